"""What a sweep panel draws on the shape while its settings change."""
from PySide import QtCore

from sweepmesh import engine
from sweepmesh.gui.overlays.plan import PlanOverlay
from sweepmesh.gui.overlays.roles import RoleOverlay
from sweepmesh.gui.runner import Runner

_DELAY = 120  # ms after the last change of a setting


class Previews(QtCore.QObject):
    """Roles of faces, vertex types and intervals, each with its own switch in the form.

    `task` returns (brep, options) as the form has them now, or raises the engine's InputError. Plans are
    made off the GUI's thread; what cannot be planned is not drawn.
    """

    def __init__(self, form, obj, task):
        super().__init__()
        self._form, self._obj, self._task = form, obj, task
        self._role_overlay, self._plan_overlay = RoleOverlay(obj), PlanOverlay(obj)
        self._roles, self._plan = {}, None
        self._planner = Runner()
        self._planner.succeeded.connect(self._show_plan)
        self._planner.failed.connect(self._clear_plan)
        self._delay = QtCore.QTimer()
        self._delay.setSingleShot(True)
        self._delay.setInterval(_DELAY)
        self._delay.timeout.connect(self._make_plan)
        form.showRoles.toggled.connect(self._draw_roles)
        for switch in (form.showTypes, form.showIntervals):
            switch.toggled.connect(self.update)

    def set_roles(self, roles):
        """Show these roles ({} where there are none), and what follows from them."""
        self._roles = dict(roles)
        self._draw_roles()
        self.update()

    def uncover(self, names):
        """Leave these faces to FreeCAD, which shows there what is selected."""
        self._role_overlay.uncover(names)

    def rebuild(self):
        """The shape has changed: take the drawings away and start with none."""
        self._role_overlay.remove()
        self._plan_overlay.remove()
        self._role_overlay, self._plan_overlay = RoleOverlay(self._obj), PlanOverlay(self._obj)

    def update(self, *_):
        """Settings have changed: plan anew, soon."""
        self._delay.start()

    def close(self):
        self._delay.stop()
        self._planner.close()
        self._role_overlay.remove()
        self._plan_overlay.remove()
        self._task = None

    def _is_plan_wanted(self):
        return self._roles and (self._form.showTypes.isChecked() or self._form.showIntervals.isChecked())

    def _make_plan(self):
        if not self._is_plan_wanted():
            self._show_plan(None)
            return
        try:
            brep, options = self._task()
        except engine.SweepMeshError:
            self._show_plan(None)
            return
        self._planner.start(lambda progress: engine.plan(brep, options, progress))

    def _draw_roles(self, *_):
        self._role_overlay.set_roles(self._roles if self._form.showRoles.isChecked() else {})

    def _clear_plan(self, *_):
        self._show_plan(None)

    def _show_plan(self, plan):
        has_types = plan and self._form.showTypes.isChecked()
        has_intervals = plan and self._form.showIntervals.isChecked()
        self._plan_overlay.show_types(plan.corners if has_types else [])
        self._plan_overlay.show_intervals(plan.intervals if has_intervals else {}, plan.edge_roles if plan else {})
