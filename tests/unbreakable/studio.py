"""What the tests of the studio share (tests/studio/studio_session.py), for the tests of this folder."""
import os
import sys

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), '../studio'))
from studio_session import *  # noqa: E402, F401, F403
