"""Runs cases through the program and reports how near the engine comes to their references."""
