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
        found = [optimize.minimize(self._loss, start, jac=True, method="L-BFGS-B", bounds=self._bounds,
                                   options={"maxiter": STEPS}) for start in (self._parameters, flat)]
        self._parameters = min(found, key=lambda result: result.fun).x
        self._condition()

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

    def after(self, places, variances, half, k, error):
        """What at() says once places[k] is measured as well. @param error its variance
        @return the variances at the places, and what covariance_with() takes"""
        row = self.covariance_with(places, half, k) / (self._scale * np.sqrt(variances[k] + self.excess * error))
        return np.maximum(variances - (self._scale * row) ** 2, self._scale ** 2 * TINY), np.vstack([half, row])

    @property
    def excess(self):
        """By what the errors' variance exceeds what was stated."""
        return float(np.exp(self._parameters[-1]))

    @property
    def stated(self):
        """The median of the errors' stated variances."""
        return float(np.median(self._variances)) * self._scale ** 2

    def _covariance(self, a, b):
        return np.exp(2.0 * self._parameters[0]) * _matern(_distances(a, b, self._parameters)) + OFFSET ** 2

    def _loss(self, parameters):
        """The negative logarithm of the parameters' probability, but for a constant, and its gradient."""
        r = _distances(self._places, self._places, parameters)
        smooth, errors = np.exp(2.0 * parameters[0]) * _matern(r), np.exp(parameters[-1]) * self._variances
        factor = linalg.cholesky(smooth + OFFSET ** 2 + np.diag(errors + TINY), lower=True)
        weights = linalg.cho_solve((factor, True), self._values)
        prior = (parameters - self._likely) / self._spreads
        loss = 0.5 * self._values @ weights + np.log(np.diag(factor)).sum() + 0.5 * prior @ prior
        by_covariance = 0.5 * (linalg.cho_solve((factor, True), np.eye(len(r))) - np.outer(weights, weights))
        by_squares = by_covariance * np.exp(2.0 * parameters[0]) * 5.0 / 3.0 * (1.0 + r) * np.exp(-r)
        scaled = self._places / np.exp(parameters[1:-1])
        by_lengths = 2.0 * (by_squares.sum(axis=1) @ scaled ** 2 - ((by_squares @ scaled) * scaled).sum(axis=0))
        return loss, prior / self._spreads + np.array([2.0 * (by_covariance * smooth).sum(), *by_lengths,
                                                       np.diag(by_covariance) @ errors])

    def _condition(self):
        errors = np.exp(self._parameters[-1]) * self._variances + TINY
        self._factor = linalg.cholesky(self._covariance(self._places, self._places) + np.diag(errors), lower=True)
        self._weights = linalg.cho_solve((self._factor, True), self._values)


def _distances(a, b, parameters):
    """In units of the lengths, as Matérn's covariance takes them."""
    lengths = np.exp(parameters[1:-1])
    return np.sqrt(5.0) * distance.cdist(a / lengths, b / lengths)


def _matern(r):
    return (1.0 + r + r * r / 3.0) * np.exp(-r)
