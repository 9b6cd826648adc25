"""A smooth surface through measurements with known errors: Gaussian process regression (Rasmussen and Williams,
Gaussian Processes for Machine Learning, MIT Press 2006, ch. 2 and 5)."""
import numpy as np
from scipy import linalg, optimize
from scipy.spatial import distance

AMPLITUDE = 0.1   # that is expected, in units of the scale: the surface's standard deviation
LENGTH = 0.3      # that is expected, in units of the ranges: over which the surface changes
OFFSET = 0.5      # standard deviation of the surface's mean, in units of the scale
# Standard deviations of the logarithms of amplitude, lengths and excess of the errors around what is expected.
SPREADS = (1.5, 0.5, 0.3)
BOUNDS = ((-7.0, 1.0), (-2.5, 2.0), (-0.5, 1.5))
STEPS = 15        # of the search for the likeliest parameters
TINY = 1e-10      # variance that keeps the matrix positive definite


class Surface:
    """Values over d ranges, each from 0 to 1. Its covariance is Matérn's of order 5/2 with a length for each range;
    the errors may be larger than stated, all by one factor. These parameters are the likeliest (maximum a
    posteriori)."""

    def __init__(self, ranges, scale=1.0, error_spread=SPREADS[2]):
        """@param ranges d. @param scale of the values. @param error_spread of the logarithm of the errors' variance"""
        self._scale = scale
        self._likely = np.array([np.log(AMPLITUDE), *[np.log(LENGTH)] * ranges, 0.0])
        self._spreads = np.array([SPREADS[0], *[SPREADS[1]] * ranges, error_spread])
        widened = BOUNDS[2] if error_spread == SPREADS[2] else (-10.0, 10.0)
        self._bounds = [BOUNDS[0], *[BOUNDS[1]] * ranges, widened]
        self._parameters = self._likely

    def fit(self, places, values, variances):
        """@param places (n, d), each once. @param values, variances (n,)"""
        self._places, self._values = places, values / self._scale
        self._variances = variances / self._scale ** 2
        flat = np.array([-4.0, *self._parameters[1:]])
        found = [optimize.minimize(self._loss, start, method="L-BFGS-B", bounds=self._bounds,
                                   options={"maxiter": STEPS}) for start in (self._parameters, flat)]
        self._parameters = min(found, key=lambda result: result.fun).x
        self._condition()

    def with_more(self, places, variances):
        """What it will know once these places are measured as well: the same surface with smaller errors."""
        more = object.__new__(Surface)
        more.__dict__.update(self.__dict__)
        more._places = np.vstack([self._places, places])
        more._values = np.concatenate([self._values, self.at(places)[0] / self._scale])
        more._variances = np.concatenate([self._variances, np.asarray(variances) / self._scale ** 2])
        more._condition()
        return more

    def at(self, places):
        """@return values (n,), their variances, and what covariance_with() takes"""
        across = self._covariance(places, self._places)
        half = linalg.solve_triangular(self._factor, across.T, lower=True)
        prior = np.exp(2.0 * self._parameters[0]) + OFFSET ** 2
        variances = np.maximum(prior - (half ** 2).sum(axis=0), TINY)
        return self._scale * (across @ self._weights), self._scale ** 2 * variances, half

    def covariance_with(self, places, half, k):
        """The covariances of the values at all places with that at places[k]."""
        return self._scale ** 2 * (self._covariance(places, places[k:k + 1])[:, 0] - half.T @ half[:, k])

    @property
    def excess(self):
        """By what the errors' variance exceeds what was stated."""
        return float(np.exp(self._parameters[-1]))

    @property
    def stated(self):
        """The median of the errors' stated variances."""
        return float(np.median(self._variances)) * self._scale ** 2

    def _covariance(self, a, b, parameters=None):
        parameters = self._parameters if parameters is None else parameters
        lengths = np.exp(parameters[1:-1])
        r = np.sqrt(5.0) * distance.cdist(a / lengths, b / lengths)
        return np.exp(2.0 * parameters[0]) * (1.0 + r + r * r / 3.0) * np.exp(-r) + OFFSET ** 2

    def _cholesky(self, parameters):
        errors = np.exp(parameters[-1]) * self._variances + TINY
        return linalg.cholesky(self._covariance(self._places, self._places, parameters) + np.diag(errors), lower=True)

    def _loss(self, parameters):
        """The negative logarithm of the parameters' probability, but for a constant."""
        factor = self._cholesky(parameters)
        z = linalg.solve_triangular(factor, self._values, lower=True)
        prior = ((parameters - self._likely) / self._spreads) ** 2
        return 0.5 * (z @ z) + np.log(np.diag(factor)).sum() + 0.5 * prior.sum()

    def _condition(self):
        self._factor = self._cholesky(self._parameters)
        self._weights = linalg.cho_solve((self._factor, True), self._values)
