<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" sourcelanguage="en" language="de">
  <context>
    <name>SweepMesh</name>
    <message>
      <source>&amp;Sweep mesh</source>
      <translation>&amp;Sweep-Netz</translation>
    </message>
    <message>
      <source>, {} pairs of patches</source>
      <translation>, {} Paare von Teilflächen</translation>
    </message>
    <message>
      <source>Across x</source>
      <translation>Quer zu x</translation>
    </message>
    <message>
      <source>Across y</source>
      <translation>Quer zu y</translation>
    </message>
    <message>
      <source>Across z</source>
      <translation>Quer zu z</translation>
    </message>
    <message>
      <source>Can the solid be swept?</source>
      <translation>Ist der Körper durchziehbar?</translation>
    </message>
    <message>
      <source>Click on a linking face, then on its vertices.</source>
      <translation>Auf eine Mantelfläche klicken, dann auf ihre Ecken.</translation>
    </message>
    <message>
      <source>Click on an edge near the end where its mesh edges are to be short.</source>
      <translation>Auf eine Kante klicken, nahe dem Ende, an dem ihre Netzkanten kurz sein sollen.</translation>
    </message>
    <message>
      <source>Click on edges of the solid.</source>
      <translation>Auf Kanten des Körpers klicken.</translation>
    </message>
    <message>
      <source>Click on vertices of {}, or on another face.</source>
      <translation>Auf Ecken von {} klicken oder auf eine andere Fläche.</translation>
    </message>
    <message>
      <source>Corner (3)</source>
      <translation>Einsprung (3)</translation>
    </message>
    <message>
      <source>Create sweep mesh</source>
      <translation>Sweep-Netz erstellen</translation>
    </message>
    <message>
      <source>Cut the solid</source>
      <translation>Den Körper schneiden</translation>
    </message>
    <message>
      <source>Edge length</source>
      <translation>Kantenlänge</translation>
    </message>
    <message>
      <source>Edit sweep mesh</source>
      <translation>Sweep-Netz bearbeiten</translation>
    </message>
    <message>
      <source>Elements in each of 20 classes of quality, from -1 to 1</source>
      <translation>Elemente in jeder von 20 Güteklassen, von -1 bis 1</translation>
    </message>
    <message>
      <source>End (1 quad)</source>
      <translation>Ende (1 Viereck)</translation>
    </message>
    <message>
      <source>Exact numbers of mesh edges on edges: Edge5=12</source>
      <translation>Genaue Anzahl der Netzkanten auf Kanten: Edge5=12</translation>
    </message>
    <message>
      <source>Faces that the mesh is swept from; empty: found</source>
      <translation>Flächen, von denen das Netz ausgeht; leer: werden gefunden</translation>
    </message>
    <message>
      <source>Faces that the sweep ends on; empty: found</source>
      <translation>Flächen, auf denen das Netz endet; leer: werden gefunden</translation>
    </message>
    <message>
      <source>First</source>
      <translation>Erste</translation>
    </message>
    <message>
      <source>Growth</source>
      <translation>Wachstum</translation>
    </message>
    <message>
      <source>Hexahedra</source>
      <translation>Hexaeder</translation>
    </message>
    <message>
      <source>Holes that wind too far to be meshed are refused at once</source>
      <translation>Löcher, die sich zu weit winden, werden sofort abgelehnt</translation>
    </message>
    <message>
      <source>How linking faces turn at vertices: Face3:Vertex7=corner</source>
      <translation>Wie Mantelflächen an Ecken abbiegen: Face3:Vertex7=corner</translation>
    </message>
    <message>
      <source>How mesh edges grow along edges: Edge5=1.2, Edge5=1.2 both</source>
      <translation>Wie Netzkanten entlang von Kanten wachsen: Edge5=1.2, Edge5=1.2 both</translation>
    </message>
    <message>
      <source>How mesh edges grow along the sweep; 1: not at all</source>
      <translation>Wie Netzkanten entlang des Durchzugs wachsen; 1: gar nicht</translation>
    </message>
    <message>
      <source>Intervals</source>
      <translation>Intervalle</translation>
    </message>
    <message>
      <source>Larger meshes are refused; 0: the default limit</source>
      <translation>Größere Netze werden abgelehnt; 0: die übliche Grenze</translation>
    </message>
    <message>
      <source>Looking for sources and targets ...</source>
      <translation>Quellen und Ziele werden gesucht ...</translation>
    </message>
    <message>
      <source>Mean quality of the elements</source>
      <translation>Mittlere Güte der Elemente</translation>
    </message>
    <message>
      <source>Nearer curves of caps become one; 0: from the size</source>
      <translation>Nähere Kurven der Deckflächen werden eine; 0: aus der Größe</translation>
    </message>
    <message>
      <source>No mesh can be made:</source>
      <translation>Es kann kein Netz gemacht werden:</translation>
    </message>
    <message>
      <source>None</source>
      <translation>Keiner</translation>
    </message>
    <message>
      <source>Number of elements by scaled Jacobian. A click on a bar shows the elements up to it.</source>
      <translation>Anzahl der Elemente nach skalierter Jacobi-Determinante. Ein Klick auf einen Balken zeigt die Elemente bis zu ihm.</translation>
    </message>
    <message>
      <source>Number of hexahedra</source>
      <translation>Anzahl der Hexaeder</translation>
    </message>
    <message>
      <source>Number of inverted elements</source>
      <translation>Anzahl der umgestülpten Elemente</translation>
    </message>
    <message>
      <source>Number of layers; 0: from the size</source>
      <translation>Anzahl der Schichten; 0: aus der Größe</translation>
    </message>
    <message>
      <source>Number of nodes</source>
      <translation>Anzahl der Knoten</translation>
    </message>
    <message>
      <source>Number of prisms</source>
      <translation>Anzahl der Prismen</translation>
    </message>
    <message>
      <source>Of the shape and settings of the mesh</source>
      <translation>Von Form und Einstellungen des Netzes</translation>
    </message>
    <message>
      <source>Order of the elements</source>
      <translation>Ordnung der Elemente</translation>
    </message>
    <message>
      <source>Prisms</source>
      <translation>Prismen</translation>
    </message>
    <message>
      <source>Quality of each element by its id</source>
      <translation>Güte jedes Elements nach seiner Nummer</translation>
    </message>
    <message>
      <source>Quality of the sweep mesh</source>
      <translation>Güte des Sweep-Netzes</translation>
    </message>
    <message>
      <source>Quality of the worst element: 1 is a cube</source>
      <translation>Güte des schlechtesten Elements: 1 ist ein Würfel</translation>
    </message>
    <message>
      <source>Reversal (4)</source>
      <translation>Umkehr (4)</translation>
    </message>
    <message>
      <source>Scaled Jacobian: least {:.3f}, mean {:.3f}; {} inverted</source>
      <translation>Skalierte Jacobi-Determinante: kleinste {:.3f}, mittlere {:.3f}; {} umgestülpt</translation>
    </message>
    <message>
      <source>Second</source>
      <translation>Zweite</translation>
    </message>
    <message>
      <source>Side (2 quads)</source>
      <translation>Seite (2 Vierecke)</translation>
    </message>
    <message>
      <source>Sweep mesh</source>
      <translation>Sweep-Netz</translation>
    </message>
    <message>
      <source>The edge length that was used</source>
      <translation>Die verwendete Kantenlänge</translation>
    </message>
    <message>
      <source>The mesh has no shape: set its property Shape first.</source>
      <translation>Das Netz hat keine Form: zuerst die Eigenschaft Shape setzen.</translation>
    </message>
    <message>
      <source>The object whose solid is meshed</source>
      <translation>Das Objekt, dessen Körper vernetzt wird</translation>
    </message>
    <message>
      <source>The run was cancelled.</source>
      <translation>Der Lauf wurde abgebrochen.</translation>
    </message>
    <message>
      <source>The run was cancelled; nothing was changed.</source>
      <translation>Der Lauf wurde abgebrochen; nichts wurde geändert.</translation>
    </message>
    <message>
      <source>The shape, under the name that older FreeCADs look for</source>
      <translation>Die Form, unter dem Namen, nach dem ältere FreeCADs suchen</translation>
    </message>
    <message>
      <source>The solid can be swept, but not with these settings:</source>
      <translation>Der Körper ist durchziehbar, aber nicht mit diesen Einstellungen:</translation>
    </message>
    <message>
      <source>The solid can be swept.</source>
      <translation>Der Körper ist durchziehbar.</translation>
    </message>
    <message>
      <source>The solid cannot be swept.</source>
      <translation>Der Körper ist nicht durchziehbar.</translation>
    </message>
    <message>
      <source>They grow from both ends to the middle</source>
      <translation>Sie wachsen von beiden Enden zur Mitte</translation>
    </message>
    <message>
      <source>Vertex type</source>
      <translation>Eckentyp</translation>
    </message>
    <message>
      <source>What each face is: source, target or linking</source>
      <translation>Was jede Fläche ist: Quelle, Ziel oder Mantel</translation>
    </message>
    <message>
      <source>What the last run warned of</source>
      <translation>Wovor der letzte Lauf gewarnt hat</translation>
    </message>
    <message>
      <source>What the mesh is made of</source>
      <translation>Woraus das Netz besteht</translation>
    </message>
    <message>
      <source>Which solid of the shape is meshed; 0: all of them</source>
      <translation>Welcher Körper der Form vernetzt wird; 0: alle</translation>
    </message>
    <message>
      <source>Which source is swept to which target: Face5=Face6</source>
      <translation>Welche Quelle zu welchem Ziel gezogen wird: Face5=Face6</translation>
    </message>
    <message>
      <source>Why the last run made no mesh; empty: it made one</source>
      <translation>Warum der letzte Lauf kein Netz gemacht hat; leer: er hat eines gemacht</translation>
    </message>
    <message>
      <source>Why the solid cannot be swept</source>
      <translation>Warum der Körper nicht durchziehbar ist</translation>
    </message>
    <message>
      <source>Wished edge length; 0: chosen from the volume</source>
      <translation>Gewünschte Kantenlänge; 0: aus dem Volumen gewählt</translation>
    </message>
    <message>
      <source>Wished edge lengths on edges: Edge5=0.8</source>
      <translation>Gewünschte Kantenlängen auf Kanten: Edge5=0.8</translation>
    </message>
    <message>
      <source>{1} of {0}: {2}</source>
      <translation>{1} von {0}: {2}</translation>
    </message>
    <message>
      <source>{} layers, edge length {:.3g} mm</source>
      <translation>{} Schichten, Kantenlänge {:.3g} mm</translation>
    </message>
    <message>
      <source>{} nodes, {} hexahedra, {} prisms</source>
      <translation>{} Knoten, {} Hexaeder, {} Prismen</translation>
    </message>
    <message>
      <source>{}: edge length {}</source>
      <translation>{}: Kantenlänge {}</translation>
    </message>
    <message>
      <source>{}: growth {:g}</source>
      <translation>{}: Wachstum {:g}</translation>
    </message>
    <message>
      <source>{}: growth {:g} from both ends</source>
      <translation>{}: Wachstum {:g} von beiden Enden</translation>
    </message>
    <message>
      <source>{}: {} intervals</source>
      <translation>{}: {} Intervalle</translation>
    </message>
  </context>
  <context>
    <name>SweepMeshOverrides</name>
    <message>
      <source>Each mesh edge is so many times as long as the one before, starting at the end near which the edge is clicked</source>
      <translation>Jede Netzkante ist so viele Male so lang wie die vorige, beginnend an dem Ende, in dessen Nähe die Kante angeklickt wird</translation>
    </message>
    <message>
      <source>From both ends</source>
      <translation>Von beiden Enden</translation>
    </message>
    <message>
      <source>How many quads of the linking face meet at the picked vertices</source>
      <translation>Wie viele Vierecke der Mantelfläche sich an den gewählten Ecken treffen</translation>
    </message>
    <message>
      <source>Mesh edges grow from both ends to the middle</source>
      <translation>Netzkanten wachsen von beiden Enden zur Mitte</translation>
    </message>
    <message>
      <source>Number of mesh edges on the picked edges</source>
      <translation>Anzahl der Netzkanten auf den gewählten Kanten</translation>
    </message>
    <message>
      <source>Numbers of mesh edges, sizes and biases of single edges. They are kept with the mesh object. Edges that are opposite each other on a linking face get equal numbers, so that one of them is enough.</source>
      <translation>Anzahlen von Netzkanten, Größen und Wachstum einzelner Kanten. Sie werden beim Netzobjekt aufbewahrt. Kanten, die sich auf einer Mantelfläche gegenüberliegen, bekommen gleiche Anzahlen; eine von ihnen genügt also.</translation>
    </message>
    <message>
      <source>Overrides</source>
      <translation>Vorgaben</translation>
    </message>
    <message>
      <source>Pick</source>
      <translation>Wählen</translation>
    </message>
    <message>
      <source>Remove</source>
      <translation>Entfernen</translation>
    </message>
    <message>
      <source>Take back what is marked in the list</source>
      <translation>Zurücknehmen, was in der Liste markiert ist</translation>
    </message>
    <message>
      <source>What is prescribed for the picked edges or vertices</source>
      <translation>Was für die gewählten Kanten oder Ecken vorgegeben wird</translation>
    </message>
    <message>
      <source>What is prescribed; what is marked is selected in the 3D view and can be changed above</source>
      <translation>Was vorgegeben ist; Markiertes ist in der 3D-Ansicht ausgewählt und kann oben geändert werden</translation>
    </message>
    <message>
      <source>While this is down, a click in the 3D view prescribes this; a second click on the same takes it back</source>
      <translation>Solange dies gedrückt ist, gibt ein Klick in der 3D-Ansicht dies vor; ein zweiter Klick auf dasselbe nimmt es zurück</translation>
    </message>
    <message>
      <source>Wished edge length on the picked edges</source>
      <translation>Gewünschte Kantenlänge auf den gewählten Kanten</translation>
    </message>
  </context>
  <context>
    <name>SweepMeshPreferences</name>
    <message>
      <source>Colour sources, targets and linking faces</source>
      <translation>Quellen, Ziele und Mantelflächen färben</translation>
    </message>
    <message>
      <source>First</source>
      <translation>Erste</translation>
    </message>
    <message>
      <source>General</source>
      <translation>Allgemein</translation>
    </message>
    <message>
      <source>Hide the solid when its mesh is made</source>
      <translation>Den Körper verbergen, wenn sein Netz gemacht ist</translation>
    </message>
    <message>
      <source>New meshes</source>
      <translation>Neue Netze</translation>
    </message>
    <message>
      <source>Number of elements that the proposed size gives</source>
      <translation>Anzahl der Elemente, die die vorgeschlagene Größe ergibt</translation>
    </message>
    <message>
      <source>Order of the elements</source>
      <translation>Ordnung der Elemente</translation>
    </message>
    <message>
      <source>Second</source>
      <translation>Zweite</translation>
    </message>
    <message>
      <source>Threads</source>
      <translation>Threads</translation>
    </message>
    <message>
      <source>View</source>
      <translation>Ansicht</translation>
    </message>
    <message>
      <source>one a processor</source>
      <translation>einer je Prozessor</translation>
    </message>
  </context>
  <context>
    <name>SweepMeshPreview</name>
    <message>
      <source>Dots are the nodes that the mesh is to have on the edges, numbers say how many mesh edges lie between. Edges along the sweep are blue, edges within a layer brown.</source>
      <translation>Punkte sind die Knoten, die das Netz auf den Kanten haben soll, Zahlen sagen, wie viele Netzkanten dazwischen liegen. Kanten entlang des Durchzugs sind blau, Kanten innerhalb einer Schicht braun.</translation>
    </message>
    <message>
      <source>How linking faces turn at their vertices: E end, S side, C corner, R reversal</source>
      <translation>Wie Mantelflächen an ihren Ecken abbiegen: E Ende, S Seite, C Einsprung, R Umkehr</translation>
    </message>
    <message>
      <source>Imprinted curves</source>
      <translation>Eingeprägte Kurven</translation>
    </message>
    <message>
      <source>Intervals</source>
      <translation>Intervalle</translation>
    </message>
    <message>
      <source>Layers are counted from the lowest targets, 0, to the highest sources. All vertices and edges of a cap lie in one layer; their colour and the number beside them say in which one.</source>
      <translation>Schichten werden von den niedrigsten Zielen, 0, zu den höchsten Quellen gezählt. Alle Ecken und Kanten einer Deckfläche liegen in einer Schicht; ihre Farbe und die Zahl sagen, in welcher.</translation>
    </message>
    <message>
      <source>Levels</source>
      <translation>Ebenen</translation>
    </message>
    <message>
      <source>Number of mesh edges on each edge: blue along the sweep, brown across it</source>
      <translation>Anzahl der Netzkanten auf jeder Kante: blau entlang des Durchzugs, braun quer dazu</translation>
    </message>
    <message>
      <source>Outlines of other sources and targets, carried over along the sweep</source>
      <translation>Umrisse anderer Quellen und Ziele, entlang des Durchzugs übertragen</translation>
    </message>
    <message>
      <source>Paired patches</source>
      <translation>Gepaarte Teilflächen</translation>
    </message>
    <message>
      <source>Parts of sources and targets in one colour are swept to each other</source>
      <translation>Teile von Quellen und Zielen in einer Farbe werden zueinander gezogen</translation>
    </message>
    <message>
      <source>Preview</source>
      <translation>Vorschau</translation>
    </message>
    <message>
      <source>Roles of the faces</source>
      <translation>Rollen der Flächen</translation>
    </message>
    <message>
      <source>Sources are drawn orange, targets blue, linking faces pale</source>
      <translation>Quellen werden orange gezeichnet, Ziele blau, Mantelflächen blass</translation>
    </message>
    <message>
      <source>The imprinted curves divide sources and targets into patches. Each patch of a target is swept to the patch of a source in the same colour.</source>
      <translation>Die eingeprägten Kurven teilen Quellen und Ziele. Jede Teilfläche eines Ziels wird zu der Teilfläche einer Quelle in derselben Farbe gezogen.</translation>
    </message>
    <message>
      <source>The layer at which the caps lie: from violet, the lowest, over green to yellow, the highest</source>
      <translation>Die Schicht, in der die Deckflächen liegen: von Violett, der niedrigsten, über Grün zu Gelb, der höchsten</translation>
    </message>
    <message>
      <source>The letters say how many quads of a linking face meet at its vertices: one at an end (E), two at a side (S), three at a corner (C), four at a reversal (R).</source>
      <translation>Die Buchstaben sagen, wie viele Vierecke einer Mantelfläche sich an ihren Ecken treffen: eines an einem Ende (E), zwei an einer Seite (S), drei an einem Einsprung (C), vier an einer Umkehr (R).</translation>
    </message>
    <message>
      <source>The mesh is swept from the sources to the targets. Linking faces lie between them and get structured grids.</source>
      <translation>Das Netz wird von den Quellen zu den Zielen gezogen. Mantelflächen liegen dazwischen und bekommen strukturierte Gitter.</translation>
    </message>
    <message>
      <source>Vertex types</source>
      <translation>Eckentypen</translation>
    </message>
    <message>
      <source>Where a sweep has several sources or targets, the outline of each is carried along the sweep to the caps above and below it and divides them. The solid itself is not cut.</source>
      <translation>Wo ein Durchzug mehrere Quellen oder Ziele hat, wird der Umriss jeder Fläche entlang des Durchzugs auf die Deckflächen über und unter ihr übertragen und teilt sie. Der Körper selbst wird nicht geschnitten.</translation>
    </message>
  </context>
  <context>
    <name>SweepMeshQuality</name>
    <message>
      <source>Draw only what lies on one side of a plane</source>
      <translation>Nur zeichnen, was auf einer Seite einer Ebene liegt</translation>
    </message>
    <message>
      <source>Elements with a scaled Jacobian up to this are drawn</source>
      <translation>Elemente mit einer skalierten Jacobi-Determinante bis zu dieser werden gezeichnet</translation>
    </message>
    <message>
      <source>Quality of the sweep mesh</source>
      <translation>Güte des Sweep-Netzes</translation>
    </message>
    <message>
      <source>Scaled Jacobian</source>
      <translation>Skalierte Jacobi-Determinante</translation>
    </message>
    <message>
      <source>Scaled Jacobian and number of the worst elements; a click shows only the element, a double click goes there</source>
      <translation>Skalierte Jacobi-Determinante und Nummer der schlechtesten Elemente; ein Klick zeigt nur das Element, ein Doppelklick geht dorthin</translation>
    </message>
    <message>
      <source>Section</source>
      <translation>Schnitt</translation>
    </message>
    <message>
      <source>Show</source>
      <translation>Zeigen</translation>
    </message>
    <message>
      <source>The elements are made ready for drawing</source>
      <translation>Die Elemente werden zum Zeichnen vorbereitet</translation>
    </message>
    <message>
      <source>The scaled Jacobian is 1 for a cube and not above 0 for an inverted element</source>
      <translation>Die skalierte Jacobi-Determinante ist 1 für einen Würfel und nicht über 0 für ein umgestülptes Element</translation>
    </message>
    <message>
      <source>Up to</source>
      <translation>Bis zu</translation>
    </message>
    <message>
      <source>Where the plane of the section lies</source>
      <translation>Wo die Schnittebene liegt</translation>
    </message>
    <message>
      <source>Worst elements</source>
      <translation>Schlechteste Elemente</translation>
    </message>
  </context>
  <context>
    <name>SweepMeshSweep</name>
    <message>
      <source>Both</source>
      <translation>Beide</translation>
    </message>
    <message>
      <source>Click on a reason to see in the 3D view what it is about</source>
      <translation>Auf einen Grund klicken, um in der 3D-Ansicht zu sehen, worum es geht</translation>
    </message>
    <message>
      <source>Curves of different caps that are nearer than this become one; 0: from the size</source>
      <translation>Kurven verschiedener Deckflächen, die näher als dies sind, werden eine; 0: aus der Größe</translation>
    </message>
    <message>
      <source>Cut there</source>
      <translation>Dort schneiden</translation>
    </message>
    <message>
      <source>Each layer is so many times as thick as the one before, from the targets to the sources; 1: even layers</source>
      <translation>Jede Schicht ist so viele Male so dick wie die vorige, von den Zielen zu den Quellen; 1: gleichmäßige Schichten</translation>
    </message>
    <message>
      <source>Elements</source>
      <translation>Elemente</translation>
    </message>
    <message>
      <source>Faces that the mesh is swept from; in italics those that were found</source>
      <translation>Flächen, von denen das Netz ausgeht; kursiv die gefundenen</translation>
    </message>
    <message>
      <source>Faces that the sweep ends on; in italics those that were found</source>
      <translation>Flächen, auf denen das Netz endet; kursiv die gefundenen</translation>
    </message>
    <message>
      <source>First order has nodes at the corners only, second order also on the edges</source>
      <translation>Die erste Ordnung hat Knoten nur an den Ecken, die zweite auch auf den Kanten</translation>
    </message>
    <message>
      <source>Forget all picks and find sources and targets</source>
      <translation>Alle Auswahl vergessen und Quellen und Ziele finden</translation>
    </message>
    <message>
      <source>Growth</source>
      <translation>Wachstum</translation>
    </message>
    <message>
      <source>Imprint</source>
      <translation>Einprägen</translation>
    </message>
    <message>
      <source>Layers</source>
      <translation>Schichten</translation>
    </message>
    <message>
      <source>Layers grow from both ends to the middle</source>
      <translation>Schichten wachsen von beiden Enden zur Mitte</translation>
    </message>
    <message>
      <source>Make the pieces of the solid as a new object, cut along the plane that is drawn, and go on with them</source>
      <translation>Die Teile des Körpers als neues Objekt machen, geschnitten an der gezeichneten Ebene, und mit ihnen weitermachen</translation>
    </message>
    <message>
      <source>Make the sources targets and the targets sources</source>
      <translation>Die Quellen zu Zielen und die Ziele zu Quellen machen</translation>
    </message>
    <message>
      <source>Mesh</source>
      <translation>Netz</translation>
    </message>
    <message>
      <source>Number of layers from the targets to the sources</source>
      <translation>Anzahl der Schichten von den Zielen zu den Quellen</translation>
    </message>
    <message>
      <source>Order</source>
      <translation>Ordnung</translation>
    </message>
    <message>
      <source>Other ways to sweep this solid, the best first</source>
      <translation>Andere Wege, diesen Körper durchzuziehen, der beste zuerst</translation>
    </message>
    <message>
      <source>Pair</source>
      <translation>Paaren</translation>
    </message>
    <message>
      <source>Pick</source>
      <translation>Wählen</translation>
    </message>
    <message>
      <source>Propose</source>
      <translation>Vorschlagen</translation>
    </message>
    <message>
      <source>Remove</source>
      <translation>Entfernen</translation>
    </message>
    <message>
      <source>Size</source>
      <translation>Größe</translation>
    </message>
    <message>
      <source>Solid</source>
      <translation>Körper</translation>
    </message>
    <message>
      <source>Sources</source>
      <translation>Quellen</translation>
    </message>
    <message>
      <source>Sources and targets</source>
      <translation>Quellen und Ziele</translation>
    </message>
    <message>
      <source>Stop</source>
      <translation>Anhalten</translation>
    </message>
    <message>
      <source>Stop the run; nothing is changed</source>
      <translation>Den Lauf anhalten; nichts wird geändert</translation>
    </message>
    <message>
      <source>Swap</source>
      <translation>Tauschen</translation>
    </message>
    <message>
      <source>Sweep mesh</source>
      <translation>Sweep-Netz</translation>
    </message>
    <message>
      <source>Sweep the marked sources to the marked target</source>
      <translation>Die markierten Quellen zum markierten Ziel ziehen</translation>
    </message>
    <message>
      <source>Take the marked faces out of the lists</source>
      <translation>Die markierten Flächen aus den Listen nehmen</translation>
    </message>
    <message>
      <source>Targets</source>
      <translation>Ziele</translation>
    </message>
    <message>
      <source>What the mesh is made of</source>
      <translation>Woraus das Netz besteht</translation>
    </message>
    <message>
      <source>Where a sweep has several sources or targets, their outlines are imprinted on each other. Outlines that nearly coincide would leave slivers: those nearer than this length are brought together.</source>
      <translation>Wo ein Durchzug mehrere Quellen oder Ziele hat, werden ihre Umrisse einander eingeprägt. Umrisse, die fast zusammenfallen, ließen Splitter übrig: die näheren als diese Länge werden zusammengeführt.</translation>
    </message>
    <message>
      <source>Which source is swept to which target, as prescribed</source>
      <translation>Welche Quelle zu welchem Ziel gezogen wird, wie vorgegeben</translation>
    </message>
    <message>
      <source>While this is down, a click on a face in the 3D view makes it a source; a second click takes it back</source>
      <translation>Solange dies gedrückt ist, macht ein Klick auf eine Fläche in der 3D-Ansicht sie zur Quelle; ein zweiter Klick nimmt es zurück</translation>
    </message>
    <message>
      <source>While this is down, a click on a face in the 3D view makes it a target; a second click takes it back</source>
      <translation>Solange dies gedrückt ist, macht ein Klick auf eine Fläche in der 3D-Ansicht sie zum Ziel; ein zweiter Klick nimmt es zurück</translation>
    </message>
    <message>
      <source>Wished edge length of the elements; 0: chosen from the volume</source>
      <translation>Gewünschte Kantenlänge der Elemente; 0: aus dem Volumen gewählt</translation>
    </message>
    <message>
      <source>from the size</source>
      <translation>aus der Größe</translation>
    </message>
  </context>
  <context>
    <name>SweepMesh_CreateMesh</name>
    <message>
      <source>Create sweep mesh</source>
      <translation>Sweep-Netz erstellen</translation>
    </message>
    <message>
      <source>Mesh the selected solid with swept hexahedra. Selected faces become sources, the last of several the target.</source>
      <translation>Den ausgewählten Körper mit durchgezogenen Hexaedern vernetzen. Ausgewählte Flächen werden Quellen, von mehreren die letzte das Ziel.</translation>
    </message>
  </context>
  <context>
    <name>SweepMesh_Quality</name>
    <message>
      <source>Quality of the sweep mesh</source>
      <translation>Güte des Sweep-Netzes</translation>
    </message>
    <message>
      <source>Show the histogram of quality, the worst elements and sections of the selected sweep mesh</source>
      <translation>Das Histogramm der Güte, die schlechtesten Elemente und Schnitte des ausgewählten Sweep-Netzes zeigen</translation>
    </message>
  </context>
</TS>
