"""What a sweep panel draws on the shape while its settings change."""
from PySide import QtCore

from sweepmesh import engine
from sweepmesh.gui.overlays.imprint import Drawing, ImprintOverlay
from sweepmesh.gui.overlays.plan import PlanOverlay, level_colour
from sweepmesh.gui.overlays.roles import COLOURS, FaceOverlay
from sweepmesh.gui.resources import tr
from sweepmesh.gui.runner import Runner

_DELAY = 10  # ms after a change of a setting: changes that come together are one


class Previews(QtCore.QObject):
    """Roles of faces, vertex types, intervals, levels and the imprint, each with its own switch in the form.

    `task` returns (brep, options) as the form has them now, or raises the engine's InputError; `models` are the
    panel's ReadModels; `emphasized` returns the names of the edges, and (face, vertex), for which something is prescribed. Plans are made off the GUI's thread; what cannot
    be planned is not drawn. `planned` tells of a plan, `failed` of the engine's error where there is none.
    """

    planned = QtCore.Signal(object)
    failed = QtCore.Signal(object)

    def __init__(self, form, obj, task, models, emphasized):
        super().__init__()
        self._form, self._obj, self._task, self._models, self._emphasized = form, obj, task, models, emphasized
        self._make_overlays()
        self._roles, self._plan, self._imprint = {}, None, None
        self._planner = Runner()
        self._planner.succeeded.connect(self._set_plan)
        self._planner.failed.connect(self._plan_failed)
        self._imprinter = Runner()
        self._imprinter.succeeded.connect(self._set_imprint)
        self._imprinter.failed.connect(self._plan_failed)
        self._delay = QtCore.QTimer()
        self._delay.setSingleShot(True)
        self._delay.setInterval(_DELAY)
        self._delay.timeout.connect(self._make_plan)
        form.showRoles.toggled.connect(self._draw_faces)
        for switch in (form.showTypes, form.showIntervals, form.showLevels):
            switch.toggled.connect(self._draw_plan)
        for switch in (form.showCurves, form.showPairs):
            switch.toggled.connect(self._imprint_toggled)

    def set_roles(self, roles):
        """Show these roles ({} where there are none), and what follows from them."""
        self._roles = dict(roles)
        self._draw_faces()
        self.update()

    def uncover(self, names):
        """Leave these faces to FreeCAD, which shows there what is selected."""
        self._face_overlay.uncover(names)

    def rebuild(self):
        """The shape has changed: take the drawings away and start with none."""
        self._remove_overlays()
        self._make_overlays()
        self._imprint = None

    def update(self, *_):
        """Settings have changed: plan anew, soon."""
        self._delay.start()

    def close(self):
        self._delay.stop()
        self._planner.close()
        self._imprinter.close()
        self._remove_overlays()
        self._task = self._emphasized = None

    def _make_overlays(self):
        self._face_overlay, self._plan_overlay = FaceOverlay(self._obj), PlanOverlay(self._obj)
        self._imprint_overlay = ImprintOverlay(self._obj)

    def _remove_overlays(self):
        for overlay in (self._face_overlay, self._plan_overlay, self._imprint_overlay):
            overlay.remove()

    def _make_plan(self):
        self._planner.close()
        self._imprinter.close()
        self._imprint = None  # drawn until there is a new one, but not to be drawn again
        if not self._roles:
            self._set_plan(None)
            self._set_imprint(None)
            return
        try:
            brep, options = self._task()
        except engine.SweepMeshError as error:
            self._plan_failed(error)
            return
        use = self._models.use
        self._planner.start(lambda progress: use(brep, lambda model: engine.plan(model, options, progress)))
        if self._is_imprint_wanted():
            self._imprinter.start(lambda progress: use(brep, lambda model: _drawing(model, options, progress)))

    def _is_imprint_wanted(self):
        return self._form.showCurves.isChecked() or self._form.showPairs.isChecked()

    def _imprint_toggled(self, *_):
        if self._imprint is None and self._is_imprint_wanted():
            self.update()
        self._draw_imprint()

    def _set_imprint(self, drawing):
        self._imprint = drawing
        self._draw_imprint()
        self._form.planSummary.setText(_summary(self._plan, drawing))

    def _draw_imprint(self):
        drawing, form = self._imprint, self._form
        self._imprint_overlay.show_pairs(drawing if form.showPairs.isChecked() else None)
        self._imprint_overlay.show_curves(drawing if form.showCurves.isChecked() else None)

    def _draw_faces(self, *_):
        colours = {}
        if self._form.showRoles.isChecked():
            colours.update({face: COLOURS[role] for face, role in self._roles.items()})
        if self._plan and self._form.showLevels.isChecked():
            highest = self._plan.n_layers
            colours.update({face: level_colour(level, highest) for face, level in self._cap_levels().items()})
        self._face_overlay.set_colours(colours)

    def _set_plan(self, plan):
        self._plan = plan if plan and plan.assessment.is_sweepable else None
        self._form.planSummary.setText(_summary(self._plan, self._imprint))
        self._draw_plan()
        if self._plan:
            self.planned.emit(self._plan)

    def _cap_levels(self):
        return self._plan_overlay.cap_levels(self._plan.levels, self._roles)

    def _plan_failed(self, error):
        self._set_plan(None)
        self._set_imprint(None)
        if not isinstance(error, engine.Cancelled):
            self.failed.emit(error)

    def _draw_plan(self, *_):
        plan, form, overlay = self._plan, self._form, self._plan_overlay
        overlay.show_types(plan.corners if plan and form.showTypes.isChecked() else [], self._emphasized())
        if plan and form.showIntervals.isChecked():
            overlay.show_intervals(plan.edge_nodes, plan.edge_roles, self._emphasized())
        else:
            overlay.show_intervals({}, {}, ())
        has_levels = plan and form.showLevels.isChecked()
        overlay.show_levels(*((plan.levels, plan.edge_nodes, self._cap_levels()) if has_levels else ({}, {}, {})))
        self._draw_faces()


def _drawing(model, options, progress):
    return Drawing(engine.imprint(model, options, progress))


def _summary(plan, drawing):
    if plan is None:
        return ""
    text = tr("{} layers, edge length {:.3g} mm").format(plan.n_layers, plan.size)
    return text + (tr(", {} pairs of patches").format(drawing.n_pairs) if drawing else "")
