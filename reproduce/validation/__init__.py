"""Other people's machines."""
from reproduce.validation import bae, okishio

STUDIES = (bae.STUDY, okishio.STUDY)
