"""The figures of the paper that the machine comes from."""
from reproduce.paper import contacts, fig3, fig4, fig5, fig7, fig8, fig9, mixtures

STUDIES = (fig3.STUDY, contacts.STUDY, fig4.STUDY, fig5.STUDY, fig7.STUDY, fig8.STUDY, mixtures.STUDY, fig9.STUDY)
