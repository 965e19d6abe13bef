"""The table of cases: a case is a row here, a scenario in scenes/validation and a reference in oracles."""
from . import contact, fingerpads, fluids, rubber, time_dependent

CASES = [*rubber.CASES, *fingerpads.CASES, *fluids.CASES, *time_dependent.CASES, *contact.CASES]
