#!/usr/bin/env python3
"""Known answers of KnownAnswersTest.cpp and StatisticsTest.cpp, computed apart from the program: Python 3.11, mpmath 1.3.

    python3 tests/unit/curriculum/known_answers.py

Each figure comes from the definition in its source: by counting all arrangements, by exact fractions, or by quantiles
that bisection of mpmath.betainc() finds. Nothing here follows the C++ code.
"""
from fractions import Fraction
from itertools import combinations, product
from statistics import quantiles, stdev

import mpmath as mp

mp.mp.dps = 30
TIMES_S = [41, 52.5, 48, 60, 55.5, 47, 63, 58, 50.5, 44, 97]


def show(name, *numbers):
    print(f"{name:34}", *(mp.nstr(mp.mpf(n.numerator) / n.denominator if isinstance(n, Fraction) else mp.mpf(n), 13)
                          for n in numbers))


def root(rising, low, high):
    """Where a rising function is 0."""
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if rising(middle) < 0 else (low, middle)
    return (low + high) / 2


def f_share(x, first, second):
    """Share of Fisher's F below x."""
    return mp.betainc(mp.mpf(first) / 2, mp.mpf(second) / 2, 0, first * x / (first * x + second), regularized=True)


def f_quantile(share, first, second):
    return root(lambda x: f_share(x, first, second) - share, mp.mpf(0), mp.mpf(10) ** 6)


def t_quantile(share, freedom):
    return mp.sqrt(f_quantile(2 * share - 1, 1, freedom))


def descriptive():
    tenths, quarters = quantiles(TIMES_S, n=10, method="inclusive"), quantiles(TIMES_S, n=4, method="inclusive")
    show("quantiles 10 25 50 75 90 %", tenths[0], *quarters, tenths[8])
    show("standard deviation", stdev([Fraction(x) for x in TIMES_S]))
    reach = 1.5 * (quarters[2] - quarters[0])
    inside = [x for x in TIMES_S if quarters[0] - reach <= x <= quarters[2] + reach]
    show("whiskers", min(inside), max(inside))
    series = [7, None, 4, 9, 3, None, 8]
    means = []
    for i, value in enumerate(series):
        window = [Fraction(x) for x in series[max(0, i - 3):i + 1] if x is not None]
        means.append(sum(window) / len(window) if value is not None else None)
    print("moving mean of 4                  ", [str(m) for m in means])


def poisson(total, count):
    """Garwood's exact interval of the mean of `count` Poisson counts with this sum."""
    share = mp.mpf("0.025")
    below = lambda mean, n: mp.gammainc(n + 1, mean, mp.inf, regularized=True)  # chance of n or fewer
    low = root(lambda mean: 1 - below(mean, total - 1) - share, mp.mpf(0), mp.mpf(100)) if total else mp.mpf(0)
    return low / count, root(lambda mean: share - below(mean, total), mp.mpf(0), mp.mpf(100)) / count


def wilson(successes, count):
    """The shares whose distance from the observed one is z of their own standard errors: (x - p)^2 n = z^2 x (1 - x)."""
    z = root(lambda x: mp.ncdf(x) - mp.mpf("0.975"), mp.mpf(0), mp.mpf(10))
    p, a = mp.mpf(successes) / count, 1 + z * z / count
    half = mp.sqrt((2 * p + z * z / count) ** 2 - 4 * a * p * p)
    return (2 * p + z * z / count - half) / (2 * a), (2 * p + z * z / count + half) / (2 * a)


def bootstrap(values):
    """Expanded percentiles (Hesterberg 2015) of the means of all n^n samples."""
    n = len(values)
    share = mp.ncdf(-mp.sqrt(mp.mpf(n) / (n - 1)) * t_quantile(mp.mpf("0.975"), n - 1))
    sums = sorted(sum(sample) for sample in product(values, repeat=n))
    return sums[int(share * len(sums))] / n, sums[int((1 - share) * len(sums))] / n


def intervals():
    times = [Fraction(x) for x in TIMES_S[:10]]
    mean, half = sum(times) / 10, t_quantile(mp.mpf("0.975"), 9) * mp.mpf(stdev(times)) / mp.sqrt(10)
    show("mean, t interval", mean, mp.mpf(mean.numerator) / mean.denominator - half,
         mp.mpf(mean.numerator) / mean.denominator + half)
    for total, count in ((0, 10), (4, 8), (2, 2)):
        show(f"Poisson, {total} in {count}", *poisson(total, count))
    for successes, count in ((3, 4), (8, 10), (0, 10)):
        show(f"Wilson, {successes} of {count}", *wilson(successes, count))
    for values in ([20, 3, 9, 2, 5], [0, 0, 1.5, 2, 4, 90], [100, 100, 95, 80, 99, 100, 100]):
        show(f"bootstrap of {len(values)} values", *bootstrap(values))
    values = [1, 2, 2, 4]
    for value in (2, 0, 9):
        ranks = [1 if x < value else Fraction(1, 2) if x == value else 0 for x in values]
        show(f"percentile rank of {value}", 100 * sum(map(Fraction, ranks)) / len(values))


def reached(success, failure, limit, rate, trials):
    """Chance that LC-CUSUM reaches a limit; a score is its numbers of successes and failures since it was last 0."""
    rate, score = Fraction(rate), lambda s, f: s * success + f * failure
    chances, signalled = {(0, 0): Fraction(1)}, Fraction(0)
    for _ in range(trials):
        following = {}
        for (s, f), chance in chances.items():
            for state, share in (((s + 1, f), 1 - rate), ((s, f + 1), rate)):
                if score(*state) <= 0:
                    state = (0, 0)
                if score(*state) >= limit:
                    signalled += chance * share
                else:
                    following[state] = following.get(state, 0) + chance * share
        chances = following
    return signalled


def cusum():
    for acceptable, unacceptable, limit, rates in (("1/10", "1/4", "3.1", ("1/4", "1/10")),
                                                   ("1/10", "2/5", "4.07", ("2/5", "1/10"))):
        p0, p1 = Fraction(acceptable), Fraction(unacceptable)
        success = mp.log(mp.mpf((1 - p0).numerator) / (1 - p0).denominator
                         / (mp.mpf((1 - p1).numerator) / (1 - p1).denominator))
        failure = mp.log(mp.mpf(p0.numerator) / p0.denominator * p1.denominator / p1.numerator)
        show(f"LC-CUSUM {p0}, {p1}: weights", success, failure)
        show(f"  fewest attempts to {limit}", mp.ceil(mp.mpf(limit) / success))
        for rate in rates:
            show(f"  signals in 50 at {limit}, rate {rate}", reached(success, failure, mp.mpf(limit), rate, 50))
        score, scores = mp.mpf(0), []
        for passed in (1, 1, 0, 1, 1, 1, 1, 0, 1):
            score = max(mp.mpf(0), score + (success if passed else failure))
            scores.append(score)
        show("  scores", *scores)


def mean_ranks(values):
    ordered = sorted(values)
    return [Fraction(2 * ordered.index(x) + ordered.count(x) + 1, 2) for x in values]


def ranks():
    for first, second in (([61, 74, 80, 66, 92, 88, 71], [55, 63, 79, 48, 70, 59, 52, 60]),
                          ([3, 5, 5, 2, 4, 4], [1, 2, 2, 3, 0, 3, 1])):
        all_ranks, n, m = mean_ranks(first + second), len(first), len(second)
        seen, middle = sum(all_ranks[:n]), Fraction(n * (n + m + 1), 2)
        sums = [sum(chosen) for chosen in combinations(all_ranks, n)]
        far = sum(abs(s - middle) >= abs(seen - middle) for s in sums)
        u = seen - Fraction(n * (n + 1), 2)
        show("Mann-Whitney U, effect, p", u, 2 * u / (n * m) - 1, Fraction(far, len(sums)))
    first, second = [i % 7 + i % 3 for i in range(25)], [i % 5 + 2 * (i % 2) + 1 for i in range(22)]
    all_values, n, m = first + second, 25, 22
    u = sum(mean_ranks(all_values)[:n]) - Fraction(n * (n + 1), 2)
    ties = sum(all_values.count(x) ** 3 - all_values.count(x) for x in set(all_values))
    variance = Fraction(n * m, 12) * (n + m + 1 - Fraction(ties, (n + m) * (n + m - 1)))
    z = (abs(u - Fraction(n * m, 2)) - Fraction(1, 2))
    show("  25 and 22: U, p", u, 2 * mp.ncdf(-mp.mpf(z.numerator) / z.denominator
                                            / mp.sqrt(mp.mpf(variance.numerator) / variance.denominator)))


def kappa():
    table = [[11, 3, 1, 0], [2, 9, 4, 1], [0, 3, 12, 5], [1, 0, 2, 6]]
    total = sum(map(sum, table))
    rows, columns = [sum(r) for r in table], [sum(c) for c in zip(*table)]
    for name, weight in (("plain", lambda d: int(d > 0)), ("linear", lambda d: d), ("quadratic", lambda d: d * d)):
        seen = sum(Fraction(weight(abs(a - b)) * table[a][b], total) for a in range(4) for b in range(4))
        chance = sum(Fraction(weight(abs(a - b)) * rows[a] * columns[b], total ** 2)
                     for a in range(4) for b in range(4))
        show(f"Cohen's kappa, {name}", 1 - seen / chance)


def icc():
    for ratings in ([[9, 2, 5, 8], [6, 1, 3, 2], [8, 4, 6, 8], [7, 1, 2, 6], [10, 5, 6, 9], [6, 2, 4, 7]],
                    [[62, 70, 65], [81, 84, 90], [45, 60, 52], [77, 75, 83], [90, 96, 92], [55, 71, 58], [68, 66, 79],
                     [73, 88, 80]]):
        x = [[Fraction(v) for v in row] for row in ratings]
        n, k = len(x), len(x[0])
        mean = sum(map(sum, x)) / (n * k)
        by_subject = [sum(row) / k for row in x]
        by_rater = [sum(column) / n for column in zip(*x)]
        subjects = k * sum((m - mean) ** 2 for m in by_subject) / (n - 1)
        raters = n * sum((m - mean) ** 2 for m in by_rater) / (k - 1)
        rest = sum((x[i][j] - by_subject[i] - by_rater[j] + mean) ** 2
                   for i in range(n) for j in range(k)) / ((n - 1) * (k - 1))
        value = (subjects - rest) / (subjects + (k - 1) * rest + k * (raters - rest) / n)
        # Shrout and Fleiss 1979, page 424.
        a, b = k * value * raters / rest, n * (1 + (k - 1) * value) - k * value
        freedom = (k - 1) * (n - 1) * (a + b) ** 2 / ((n - 1) * a ** 2 + b ** 2)
        freedom, bms, jms, ems = (mp.mpf(q.numerator) / q.denominator for q in (freedom, subjects, raters, rest))
        upper, lower = f_quantile(mp.mpf("0.975"), n - 1, freedom), f_quantile(mp.mpf("0.975"), freedom, n - 1)
        other = k * jms + (k * n - k - n) * ems
        show("ICC(2,1), from, to", value, n * (bms - upper * ems) / (upper * other + n * bms),
             n * (lower * bms - ems) / (other + n * lower * bms))


def learning():
    times = [150, 112, 104, 88, 90, 79, 83, 74, 77, 71, 74, 68, 72, 66]
    n = len(times)

    def linear(rate):
        """Plateau, gain and squares for a rate, by the normal equations."""
        xs = [mp.mpf(i) ** -rate for i in range(1, n + 1)]
        sx, sy = mp.fsum(xs), mp.fsum(times)
        sxx, sxy = mp.fsum(x * x for x in xs), mp.fsum(x * y for x, y in zip(xs, times))
        gain = (n * sxy - sx * sy) / (n * sxx - sx * sx)
        plateau = (sy - gain * sx) / n
        return plateau, gain, mp.fsum((y - plateau - gain * x) ** 2 for x, y in zip(xs, times))

    golden, low, high = (mp.sqrt(5) - 1) / 2, mp.mpf("0.06"), mp.mpf(5)
    while high - low > mp.mpf(10) ** -14:
        left, right = high - golden * (high - low), low + golden * (high - low)
        low, high = (low, right) if linear(left)[2] < linear(right)[2] else (left, high)
    rate = (low + high) / 2
    plateau, gain, squares = linear(rate)
    jacobian = mp.matrix([[1, mp.mpf(i) ** -rate, -gain * mp.log(i) * mp.mpf(i) ** -rate] for i in range(1, n + 1)])
    variance = squares / (n - 3)
    spread = variance * (jacobian.T * jacobian) ** -1
    half = t_quantile(mp.mpf("0.975"), n - 3)
    show("power curve: plateau, from, to", plateau, plateau - half * mp.sqrt(spread[0, 0]),
         plateau + half * mp.sqrt(spread[0, 0]))
    show("  gain, rate, residual", gain, rate, mp.sqrt(variance))
    row = jacobian[4, :]
    show("  at attempt 5, half of its band", plateau + gain * mp.mpf(5) ** -rate,
         half * mp.sqrt((row * spread * row.T)[0, 0]))


descriptive(), intervals(), cusum(), ranks(), kappa(), icc(), learning()
