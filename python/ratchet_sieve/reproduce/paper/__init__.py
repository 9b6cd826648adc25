"""The figures of the paper that the machine comes from."""
from ratchet_sieve.reproduce.paper import (chute, contacts, deck, fig3, fig4, fig5, fig6, fig7, fig8, fig9, guide,
                                           length, mixtures, open_base, parting_pairs, parting_teeth, parting_window)

STUDIES = (fig3.STUDY, contacts.STUDY, fig4.STUDY, fig5.STUDY, fig6.STUDY, fig7.STUDY, fig8.STUDY, mixtures.STUDY,
           fig9.STUDY, guide.STUDY, parting_window.STUDY, parting_pairs.STUDY, parting_teeth.STUDY,
           open_base.STUDY, deck.STUDY, length.STUDY, chute.STUDY)
