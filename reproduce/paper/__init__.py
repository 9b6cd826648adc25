"""The figures of the paper that the machine comes from."""
from reproduce.paper import (contacts, fig3, fig4, fig5, fig7, fig8, fig9, length, mixtures, parting_pairs,
                             parting_window)

STUDIES = (fig3.STUDY, contacts.STUDY, fig4.STUDY, fig5.STUDY, fig7.STUDY, fig8.STUDY, parting_window.STUDY,
           parting_pairs.STUDY, mixtures.STUDY, fig9.STUDY, length.STUDY)
