"""Other people's machines."""
from ratchet_sieve.reproduce.validation import bae, farkas_friction, farkas_restitution, layer, okishio, rapaport

STUDIES = (farkas_restitution.STUDY, farkas_friction.STUDY, layer.STUDY, bae.STUDY, okishio.STUDY,
           rapaport.STUDY)
