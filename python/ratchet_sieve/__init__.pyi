"""What __init__.py imports when it is first used."""
from . import documents as documents
from . import env as env
from . import errors as errors
from . import origin as origin
from . import plots as plots
from . import stats as stats
from . import tables as tables
from .answers import separate as separate
from .answers.answer import Answer as Answer
from .answers.front import Front as Front
from .answers.front import front as front
from .bags import read_bag as read_bag
from .errors import BagError as BagError
from .errors import ResultsError as ResultsError
from .errors import SceneError as SceneError
from .errors import SieveWarning as SieveWarning
from .errors import StallError as StallError
from .errors import StateError as StateError
from .pages import LivePage as LivePage
from .pages import live as live
from .runs import KINDS as KINDS
from .runs import Collisions as Collisions
from .runs import Frames as Frames
from .runs import Recording as Recording
from .runs import Run as Run
from .runs import run as run
from .scene import Scene as Scene
from .simulation import Simulation as Simulation
from .sweeps import read_sweep as read_sweep
from .sweeps import sweep as sweep
from .values import Summary as Summary
from .values import Values as Values

__version__: str
