"""View providers. Importing this package lets app dress the views of the objects that it makes."""
from sweepmesh.app.views import register_view
from sweepmesh.gui.viewproviders.view_sweep import ViewSweep

register_view("Sweep", ViewSweep)
