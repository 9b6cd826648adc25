"""Other people's machines."""
from reproduce.validation import bae, layer, okishio

STUDIES = (layer.STUDY, bae.STUDY, okishio.STUDY)
