"""Other people's machines."""

STUDIES = ()
