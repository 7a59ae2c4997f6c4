"""What the tests of the command line share (tests/cli/swaplight_cli.py), for the tests of this folder."""
import os
import sys

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), '../cli'))
from swaplight_cli import *  # noqa: E402, F401, F403
