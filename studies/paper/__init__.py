"""The figures of the paper that the machine comes from."""
from paper import (chute, contacts, deck, displacements, fig5, fig6, fig7, fig8, fig9, guide, heights, length, mixtures,
                   open_base, parting, parting_pairs, parting_teeth, restitution)

STUDIES = (displacements.STUDY, contacts.STUDY, fig5.STUDY, fig6.STUDY, fig7.STUDY, restitution.STUDY, fig8.STUDY,
           mixtures.STUDY, fig9.STUDY, guide.STUDY, parting.WINDOW, parting_pairs.STUDY, parting_teeth.STUDY,
           open_base.STUDY, deck.STUDY, length.STUDY, chute.STUDY, heights.STUDY)
