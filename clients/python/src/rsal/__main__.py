"""``python -m rsal`` is the command ``rsal``."""

from rsal.launch import main

main()
