"""`python -m hyzer` is the program `hyzer`."""

import sys

from hyzer._program import main

sys.exit(main())
