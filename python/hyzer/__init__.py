"""hyzer."""
from hyzer._hyzer import Model
