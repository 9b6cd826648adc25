"""Other people's machines."""
from validation import bae, farkas, layer, okishio, rapaport

STUDIES = (farkas.RESTITUTION, farkas.FRICTION, layer.STUDY, bae.STUDY, okishio.STUDY, rapaport.STUDY)
