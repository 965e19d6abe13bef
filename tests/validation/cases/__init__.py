"""The table of cases: a case is a row here, a scenario in scenes/validation and a reference in oracles."""
from . import airbag, contact, cuts, fingerpads, fluids, friction, rubber, sheets, shells, time_dependent

CASES = [*sheets.CASES, *rubber.CASES, *airbag.CASES, *fingerpads.CASES, *fluids.CASES, *time_dependent.CASES, *contact.CASES,
         *friction.CASES, *shells.CASES, *cuts.CASES]
