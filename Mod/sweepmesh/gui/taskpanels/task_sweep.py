"""The task panel that makes or edits a sweep mesh."""
import FreeCAD
import FreeCADGui
from PySide import QtCore, QtGui

from sweepmesh import engine
from sweepmesh.app import overrides, preferences
from sweepmesh.app.objects.sweep import options_of
from sweepmesh.app.remembered import remember
from sweepmesh.app.shapes import brep_of, proposed_size
from sweepmesh.app.stages import faces_with, options_for
from sweepmesh.gui import recorder
from sweepmesh.gui.read_models import ReadModels
from sweepmesh.gui.resources import Widgets, icon, let_go, load_form, tr
from sweepmesh.gui.runner import STOP_SECONDS, Runner
from sweepmesh.gui.taskpanels.cut_offer import CutOffer
from sweepmesh.gui.taskpanels.face_lists import FaceLists
from sweepmesh.gui.taskpanels.overrides import Overrides
from sweepmesh.gui.taskpanels.picking import Picking
from sweepmesh.gui.taskpanels.previews import Previews

ELEMENTS = ("hex", "prism")  # what FreeCAD's FEM meshes hold
FORMS = {"Sweep": "Sweep", "Overrides": "Overrides", "Preview": "Roles"}  # and their icons


class SweepPanel:
    """Sources, targets and settings with a live proposal; OK meshes in a thread and then stores.

    `shape` is the object with the solid, `faces` the names of faces picked before; `mesh` is the mesh object
    to edit, none to make one. Nothing in the document changes before a mesh stands.
    """

    def __init__(self, shape, faces=(), mesh=None):
        self._shape, self._mesh, self._document_name = shape, mesh, shape.Document.Name
        self._schemes, self._is_plan_refused = [], False
        self.form = [load_form(name) for name in FORMS]  # FreeCAD shows each as a box that can be folded
        for form, name in zip(self.form, FORMS):
            form.setWindowIcon(QtGui.QIcon(icon(FORMS[name])))
        self.widgets = Widgets(self.form)
        self._picking, self._models = Picking(shape), ReadModels()
        self._faces = FaceLists(self.widgets, shape, self._picking)
        self._overrides = Overrides(self.widgets, shape, self._picking)
        self._previews = Previews(self.widgets, shape, self._task, self._models, self._overrides.names)
        self._cut = CutOffer(self.widgets, shape)
        self._assessor, self._mesher = Runner(), Runner()
        self._connect()
        self.load(faces)
        self._is_open = True
        self._visible = self._show_solid()
        FreeCAD.addDocumentObserver(self)
        self.form[0].destroyed.connect(self._form_is_gone)

    # --- settings -------------------------------------------------------------------------------------

    def load(self, faces):
        """Show the settings of the mesh object, or those to start with."""
        form = self.widgets
        form.shapeName.setText(self._shape.Label)
        form.shapeName.setToolTip(self._shape.Label)
        form.showRoles.setChecked(preferences.colour_faces())
        stored = self._stored_options()
        options = stored or self._first_options()
        self._others = {name: getattr(options, name) for name in ("max_elements", "solid", "refuse_folds")}
        form.meshSize.setProperty("rawValue", options.size or 0.0)
        form.layerCount.setValue(options.layers or 0)
        form.elementKind.setCurrentIndex(ELEMENTS.index(options.element) if options.element in ELEMENTS else 0)
        form.elementOrder.setCurrentIndex(options.order - 1)
        form.imprintTolerance.setProperty("rawValue", options.imprint_tolerance or 0.0)
        ratio, is_symmetric = options.sweep_bias or (1.0, False)
        form.sweepRatio.setValue(ratio)
        form.sweepBoth.setChecked(is_symmetric)
        self._overrides.set(options.size, _named(options))
        if stored:
            picks = _names(options.sources), _names(options.targets), [tuple(_names(pair)) for pair in options.pairs]
        else:
            picks = _split(faces)
        self._faces.set_picks(*picks)

    def _stored_options(self):
        """Return the options of the mesh object; None where there is none or its links lead nowhere."""
        try:
            return options_of(self._mesh) if self._mesh else None
        except engine.SweepMeshError as error:
            FreeCAD.Console.PrintWarning(f"{error}\n")
            return None

    def _first_options(self):
        size = proposed_size(self._shape, preferences.wished_elements())
        return engine.Options(size=size, order=preferences.order())

    def settings(self):
        """Return the settings of the form by the names that `make_sweep_mesh` takes."""
        form = self.widgets
        ratio = round(form.sweepRatio.value(), 6)
        return {
            "size": form.meshSize.property("rawValue") or None,
            "layers": form.layerCount.value() or None,
            "element": ELEMENTS[form.elementKind.currentIndex()],
            "order": form.elementOrder.currentIndex() + 1,
            "sources": list(self._faces.picks["source"]),
            "targets": list(self._faces.picks["target"]),
            "pairs": list(self._faces.pairs),
            "sweep_bias": None if ratio == 1.0 else (ratio, form.sweepBoth.isChecked()),
            "imprint_tolerance": form.imprintTolerance.property("rawValue") or None,
            **self._overrides.settings(),
        }

    def _connect(self):
        form = self.widgets
        form.elementKind.addItems([tr("Hexahedra"), tr("Prisms")])
        form.elementOrder.addItems([tr("First"), tr("Second")])
        self._faces.changed.connect(self.assess)
        self._overrides.changed.connect(self._previews.update)
        self._overrides.types_changed.connect(self.assess)
        self._overrides.started.connect(self._show_what_is_picked)
        self._picking.selected.connect(self._previews.uncover)
        self._previews.planned.connect(self._show_plan)
        self._previews.failed.connect(self._show_plan_error)
        form.propose.clicked.connect(self._propose)
        form.schemes.activated.connect(self._choose_scheme)
        for length in (form.meshSize, form.imprintTolerance):
            QtCore.QObject.connect(length, QtCore.SIGNAL("valueChanged(double)"), self._previews.update)
        form.sweepRatio.valueChanged.connect(self._previews.update)
        form.sweepBoth.toggled.connect(self._previews.update)
        form.layerCount.valueChanged.connect(self._previews.update)
        form.elementKind.currentIndexChanged.connect(self._previews.update)
        form.reasons.itemSelectionChanged.connect(self._select_entities)
        form.stop.clicked.connect(self._mesher.cancel)
        self._assessor.succeeded.connect(self._show_assessment)
        self._assessor.failed.connect(self._show_error)
        self._cut.accepted.connect(self._make_cut)
        self._mesher.progressed.connect(self._show_progress)
        self._mesher.succeeded.connect(self._store)
        self._mesher.failed.connect(self._mesh_failed)
        self._show_running(False)

    # --- the proposal ---------------------------------------------------------------------------------

    def assess(self):
        """Start to find out what the picks make of the solid."""
        self._cut.withdraw()
        self._faces.show_roles({})
        self._overrides.set_caps([*self._faces.picks["source"], *self._faces.picks["target"]])
        self.widgets.verdict.setText(tr("Looking for sources and targets ..."))
        try:
            brep, options = self._task()
        except engine.SweepMeshError as error:
            self._show_error(error)
            return
        use = self._models.use
        self._assessor.start(lambda progress: use(brep, lambda model: engine.assess(model, options, progress)))

    def _show_assessment(self, assessment):
        self._schemes, self._is_plan_refused = assessment.schemes, False
        self._faces.show_roles(assessment.roles)
        self._previews.set_roles(assessment.roles)
        self._show_reasons([(reason.text, reason.entities) for reason in assessment.reasons])
        is_sweepable = assessment.verdict == "sweepable"
        if not is_sweepable:
            self._cut.look(*self._task())
        self.widgets.verdict.setText(tr("The solid can be swept.") if is_sweepable else tr("The solid cannot be swept."))
        self.widgets.schemes.clear()
        self.widgets.schemes.addItems([_scheme_text(scheme) for scheme in self._schemes])
        self.widgets.schemes.setVisible(len(self._schemes) > 1)

    def _propose(self):
        self._faces.set_picks([], [])

    def _choose_scheme(self, index):
        scheme = self._schemes[index]
        self._faces.set_picks(faces_with(scheme, "source"), faces_with(scheme, "target"))

    def _show_plan(self, plan):
        """The settings can be met: what was said against them is settled."""
        if self._is_plan_refused:
            self._is_plan_refused = False
            self.widgets.verdict.setText(tr("The solid can be swept."))
            self._show_reasons([])

    def _show_plan_error(self, error):
        self._is_plan_refused = True
        self.widgets.verdict.setText(tr("The solid can be swept, but not with these settings:"))
        self._show_reasons([(str(error), list(getattr(error, "entities", ())))])

    def _show_what_is_picked(self, setting):
        switch = self.widgets.showTypes if setting == "vertex_types" else self.widgets.showIntervals
        switch.setChecked(True)

    def _show_error(self, error):
        self._schemes = []
        self._previews.set_roles({})
        self.widgets.verdict.setText(tr("No mesh can be made:"))
        self._show_reasons([(str(error), list(getattr(error, "entities", ())))])

    def _show_reasons(self, reasons):
        self.widgets.reasons.clear()
        for text, entities in reasons:
            item = QtGui.QListWidgetItem(text)
            item.setToolTip(", ".join(entities))
            item.setData(QtCore.Qt.UserRole, list(entities))
            self.widgets.reasons.addItem(item)
        self.widgets.reasons.setVisible(bool(reasons))

    def _select_entities(self):
        FreeCADGui.Selection.clearSelection()
        for item in self.widgets.reasons.selectedItems():
            for entity in item.data(QtCore.Qt.UserRole):
                FreeCADGui.Selection.addSelection(self._shape, entity)

    # --- the run --------------------------------------------------------------------------------------

    def accept(self):
        """OK: start the run. The panel closes itself when the mesh stands, and stays with the reason if not."""
        if self._mesher.is_running():
            return False
        try:
            brep, options = self._task()
        except engine.SweepMeshError as error:
            self._show_error(error)
            return False
        self._show_running(True)
        self._mesher.start(lambda progress: (brep, options, engine.mesh(brep, options, progress)))
        return False

    def reject(self):
        """Cancel: stop what runs and leave the document as it is."""
        self._restore_visibility()
        self._close()
        return True

    def _task(self):
        settings = {**self.settings(), **self._others, "threads": preferences.threads()}
        return brep_of(self._shape), options_for(self._shape, **settings)

    def _show_running(self, is_running):
        for name in ("facesBox", "meshBox", "SweepMeshOverrides"):
            getattr(self.widgets, name).setEnabled(not is_running)
        self.widgets.running.setVisible(is_running)

    def _show_progress(self, fraction, message):
        self.widgets.progress.setValue(round(100 * fraction))
        self.widgets.progress.setFormat(f"{message} %p %" if message else "%p %")

    def _mesh_failed(self, error):
        self._show_running(False)
        if isinstance(error, engine.Cancelled):
            self.widgets.verdict.setText(tr("The run was cancelled; nothing was changed."))
        else:
            self._show_error(error)

    def _store(self, outcome):
        brep, options, result = outcome
        self._show_running(False)
        if result.assessment.verdict != "sweepable":
            self._show_assessment(result.assessment)
            return
        remember(brep, options, result)
        title, lines = self._lines()
        self._restore_visibility()
        recorder.run(self._shape.Document, title, lines)
        self._close()

    def _lines(self):
        """What OK does, as recorded Python."""
        settings = self.settings()
        if self._mesh:
            stored = self._stored_options()
            changed = recorder.arguments(_changes(stored, settings) if stored else settings)
            arguments = [recorder.reference(self._mesh), *changed]
            return tr("Edit sweep mesh"), [f"sweepmesh.app.update_sweep_mesh({', '.join(arguments)})"]
        shape = recorder.reference(self._shape)
        arguments = [shape, *recorder.arguments(_changes(engine.Options(), settings))]
        analysis = recorder.active_analysis(self._shape.Document)
        if analysis:
            arguments.append(f"analysis={recorder.reference(analysis)}")
        lines = [f"mesh = sweepmesh.app.make_sweep_mesh({', '.join(arguments)})"]
        if preferences.hide_solid():
            lines.append(f"{shape}.Visibility = False")
        return tr("Create sweep mesh"), lines

    def _make_cut(self, cut):
        """Cut the solid as offered; a panel for its pieces takes the place of this one."""
        shape, document = recorder.reference(self._shape), self._shape.Document
        point, normal = (tuple(round(x, 9) for x in vector) for vector in (cut.point, cut.normal))
        lines = [f"pieces = sweepmesh.app.make_cut({shape}, point={point}, normal={normal})", f"{shape}.Visibility = False"]
        self._restore_visibility()
        recorder.run(document, tr("Cut the solid"), lines)
        pieces = document.Objects[-1]
        self._close()
        QtCore.QTimer.singleShot(0, lambda: FreeCADGui.Control.showDialog(SweepPanel(pieces)))

    def _show_solid(self):
        """Show the solid, and hide the mesh that is edited. Return what was visible before."""
        objects = [self._shape, self._mesh] if self._mesh else [self._shape]
        before = [(obj, obj.ViewObject.Visibility) for obj in objects]
        for obj in objects:
            obj.ViewObject.Visibility = obj == self._shape
        return before

    def _restore_visibility(self, without=None):
        for obj, was_visible in self._visible:
            if obj != without:
                obj.ViewObject.Visibility = was_visible
        self._visible = []

    # --- the end --------------------------------------------------------------------------------------

    def _close(self):
        """End the panel; shape, mesh or document may be going just now."""
        self._stop()
        let_go(self.form)
        name = self._document_name
        QtCore.QTimer.singleShot(0, lambda: _leave_edit_and_close(name))

    def _form_is_gone(self, *_):
        """FreeCAD has closed the panel without asking it, as it does where a script ends the edit."""
        if self._is_open:
            self._restore_visibility()
            self._stop()

    def _stop(self):
        """Stop all work and take everything out of the view."""
        self._is_open = False
        FreeCAD.removeDocumentObserver(self)
        self._assessor.close()
        self._mesher.close(wait=STOP_SECONDS)
        self._picking.close()
        self._previews.close()
        self._cut.close()

    def slotChangedObject(self, obj, name):
        """FreeCAD calls this when a property changed: another shape needs other drawings and a new verdict."""
        if obj == self._shape and name == "Shape" and not self._mesher.is_running():
            QtCore.QTimer.singleShot(0, self._shape_changed)

    def _shape_changed(self):
        if self._is_open:
            self._previews.rebuild()
            self.assess()

    def slotDeletedDocument(self, document):
        """FreeCAD calls this when a document is about to be closed."""
        if document.Name == self._document_name:
            self._close()

    def slotDeletedObject(self, obj):
        """FreeCAD calls this when an object is about to be deleted."""
        if obj in (self._shape, self._mesh):
            self._restore_visibility(without=obj)
            self._close()


def _leave_edit_and_close(document_name):
    if document_name in FreeCAD.listDocuments():
        document = FreeCADGui.getDocument(document_name)
        if document.getInEdit():
            document.resetEdit()
    FreeCADGui.Control.closeDialog()


def _names(numbers):
    return [f"Face{number}" for number in numbers]


def _named(options):
    """The overrides in `options`, edges, faces and vertices by their names."""
    return {name: overrides.by_name(name, getattr(options, name)) for name in overrides.PROPERTIES}


def _split(faces):
    """Faces selected before: sources; of several the last is the target."""
    faces = list(faces)
    return (faces[:-1], faces[-1:]) if len(faces) > 1 else (faces, [])


def _scheme_text(scheme):
    return f"{', '.join(faces_with(scheme, 'source'))} \N{RIGHTWARDS ARROW} {', '.join(faces_with(scheme, 'target'))}"


def _changes(options, settings):
    """Return the settings that differ from `options`."""
    faces = {"sources": _names(options.sources), "targets": _names(options.targets)}
    old = {**vars(options), **faces, **_named(options), "pairs": [tuple(_names(pair)) for pair in options.pairs]}
    return {name: value for name, value in settings.items() if value != old[name]}
