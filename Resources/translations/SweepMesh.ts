<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" sourcelanguage="en">
  <context>
    <name>SweepMesh</name>
    <message>
      <source>&amp;Sweep mesh</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>, {} pairs of patches</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Across x</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Across y</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Across z</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Can the solid be swept?</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Click on a linking face, then on its vertices.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Click on an edge near the end where its mesh edges are to be short.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Click on edges of the solid.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Click on vertices of {}, or on another face.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Corner (3)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Create sweep mesh</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cut the solid</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Edge length</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Edit sweep mesh</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Elements in each of 20 classes of quality, from -1 to 1</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>End (1 quad)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Exact numbers of mesh edges on edges: Edge5=12</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Faces that the mesh is swept from; empty: found</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Faces that the sweep ends on; empty: found</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>First</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Growth</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Hexahedra</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Holes that wind too far to be meshed are refused at once</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>How linking faces turn at vertices: Face3:Vertex7=corner</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>How mesh edges grow along edges: Edge5=1.2, Edge5=1.2 both</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>How mesh edges grow along the sweep; 1: not at all</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Intervals</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Larger meshes are refused; 0: the default limit</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Looking for sources and targets ...</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Mean quality of the elements</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Nearer curves of caps become one; 0: from the size</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>No mesh can be made:</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>None</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Number of elements by scaled Jacobian. A click on a bar shows the elements up to it.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Number of hexahedra</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Number of inverted elements</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Number of layers; 0: from the size</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Number of nodes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Number of prisms</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Of the shape and settings of the mesh</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Order of the elements</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Prisms</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Quality of each element by its id</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Quality of the sweep mesh</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Quality of the worst element: 1 is a cube</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Reversal (4)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Scaled Jacobian: least {:.3f}, mean {:.3f}; {} inverted</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Second</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Side (2 quads)</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Sweep mesh</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The edge length that was used</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The mesh has no shape: set its property Shape first.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The object whose solid is meshed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The run was cancelled.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The run was cancelled; nothing was changed.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The shape, under the name that older FreeCADs look for</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The solid can be swept, but not with these settings:</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The solid can be swept.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The solid cannot be swept.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>They grow from both ends to the middle</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Vertex type</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>What each face is: source, target or linking</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>What the last run warned of</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>What the mesh is made of</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Which solid of the shape is meshed; 0: all of them</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Which source is swept to which target: Face5=Face6</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Why the last run made no mesh; empty: it made one</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Why the solid cannot be swept</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Wished edge length; 0: chosen from the volume</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Wished edge lengths on edges: Edge5=0.8</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{1} of {0}: {2}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{} layers, edge length {:.3g} mm</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{} nodes, {} hexahedra, {} prisms</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{}: edge length {}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{}: growth {:g}</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{}: growth {:g} from both ends</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>{}: {} intervals</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>SweepMeshOverrides</name>
    <message>
      <source>Each mesh edge is so many times as long as the one before, starting at the end near which the edge is clicked</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>From both ends</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>How many quads of the linking face meet at the picked vertices</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Mesh edges grow from both ends to the middle</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Number of mesh edges on the picked edges</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Numbers of mesh edges, sizes and biases of single edges. They are kept with the mesh object. Edges that are opposite each other on a linking face get equal numbers, so that one of them is enough.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Overrides</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pick</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Remove</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Take back what is marked in the list</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>What is prescribed for the picked edges or vertices</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>What is prescribed; what is marked is selected in the 3D view and can be changed above</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>While this is down, a click in the 3D view prescribes this; a second click on the same takes it back</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Wished edge length on the picked edges</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>SweepMeshPreferences</name>
    <message>
      <source>Colour sources, targets and linking faces</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>First</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>General</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Hide the solid when its mesh is made</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>New meshes</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Number of elements that the proposed size gives</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Order of the elements</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Second</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Threads</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>View</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>one a processor</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>SweepMeshPreview</name>
    <message>
      <source>Dots are the nodes that the mesh is to have on the edges, numbers say how many mesh edges lie between. Edges along the sweep are blue, edges within a layer brown.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>How linking faces turn at their vertices: E end, S side, C corner, R reversal</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Imprinted curves</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Intervals</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Layers are counted from the lowest targets, 0, to the highest sources. All vertices and edges of a cap lie in one layer; their colour and the number beside them say in which one.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Levels</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Number of mesh edges on each edge: blue along the sweep, brown across it</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Outlines of other sources and targets, carried over along the sweep</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Paired patches</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Parts of sources and targets in one colour are swept to each other</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Preview</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Roles of the faces</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Sources are drawn orange, targets blue, linking faces pale</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The imprinted curves divide sources and targets into patches. Each patch of a target is swept to the patch of a source in the same colour.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The layer at which the caps lie: from violet, the lowest, over green to yellow, the highest</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The letters say how many quads of a linking face meet at its vertices: one at an end (E), two at a side (S), three at a corner (C), four at a reversal (R).</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The mesh is swept from the sources to the targets. Linking faces lie between them and get structured grids.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Vertex types</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Where a sweep has several sources or targets, the outline of each is carried along the sweep to the caps above and below it and divides them. The solid itself is not cut.</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>SweepMeshQuality</name>
    <message>
      <source>Draw only what lies on one side of a plane</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Elements with a scaled Jacobian up to this are drawn</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Quality of the sweep mesh</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Scaled Jacobian</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Scaled Jacobian and number of the worst elements; a click shows only the element, a double click goes there</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Section</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Show</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The elements are made ready for drawing</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>The scaled Jacobian is 1 for a cube and not above 0 for an inverted element</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Up to</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Where the plane of the section lies</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Worst elements</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>SweepMeshSweep</name>
    <message>
      <source>Both</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Click on a reason to see in the 3D view what it is about</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Curves of different caps that are nearer than this become one; 0: from the size</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Cut there</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Each layer is so many times as thick as the one before, from the targets to the sources; 1: even layers</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Elements</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Faces that the mesh is swept from; in italics those that were found</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Faces that the sweep ends on; in italics those that were found</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>First order has nodes at the corners only, second order also on the edges</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Forget all picks and find sources and targets</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Growth</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Imprint</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Layers</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Layers grow from both ends to the middle</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Make the pieces of the solid as a new object, cut along the plane that is drawn, and go on with them</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Make the sources targets and the targets sources</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Mesh</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Number of layers from the targets to the sources</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Order</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Other ways to sweep this solid, the best first</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pair</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Pick</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Propose</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Remove</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Size</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Solid</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Sources</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Sources and targets</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stop</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Stop the run; nothing is changed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Swap</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Sweep mesh</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Sweep the marked sources to the marked target</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Take the marked faces out of the lists</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Targets</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>What the mesh is made of</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Where a sweep has several sources or targets, their outlines are imprinted on each other. Outlines that nearly coincide would leave slivers: those nearer than this length are brought together.</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Which source is swept to which target, as prescribed</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>While this is down, a click on a face in the 3D view makes it a source; a second click takes it back</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>While this is down, a click on a face in the 3D view makes it a target; a second click takes it back</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Wished edge length of the elements; 0: chosen from the volume</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>from the size</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>SweepMesh_CreateMesh</name>
    <message>
      <source>Create sweep mesh</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Mesh the selected solid with swept hexahedra. Selected faces become sources, the last of several the target.</source>
      <translation type="unfinished" />
    </message>
  </context>
  <context>
    <name>SweepMesh_Quality</name>
    <message>
      <source>Quality of the sweep mesh</source>
      <translation type="unfinished" />
    </message>
    <message>
      <source>Show the histogram of quality, the worst elements and sections of the selected sweep mesh</source>
      <translation type="unfinished" />
    </message>
  </context>
</TS>
