#!/usr/bin/env python3
"""Writes sweep_models.txt, the numbers that the models of a sweep are checked against, with statsmodels and SciPy
(Debian 12: python3-statsmodels 0.13.5, python3-scipy 1.10.1). The tests read the file; they need no Python.

blocks NAME      the model log(value) = arm + block, launch as random effect
value L B A Y    a value of launch L, block B within it, arm A
contrast F S ESTIMATE ERROR DF P      arm S less arm F, by ordinary least squares (statsmodels OLS); of one launch: of the values;
                 of several: of the arms' effects within each launch
mixed F S ESTIMATE ERROR              the same by REML of the mixed model (statsmodels MixedLM), where all blocks are complete
effects NAME     the random-effects model of several machines
machine Y SE     the logarithm of a ratio and its standard error
pooled TAU2 MEAN ERROR LOW HIGH PREDICTION_LOW PREDICTION_HIGH
                 REML by minimising the restricted likelihood (SciPy), Hartung and Knapp's error, not below the one
                 without their factor, and Student's t with k - 1 degrees
"""
import sys
import numpy as np
import pandas
import statsmodels.formula.api as smf
from scipy import optimize, stats

ARMS = 4
random = np.random.default_rng(20261124)


def draw(launches, blocks, gaps, launch_sd):
    rows = []
    for launch in range(launches):
        arm_effect = random.normal(0, launch_sd, ARMS)
        for block in range(blocks):
            shared = random.normal(0, 0.2)
            for arm in range(ARMS):
                value = 7 + 0.05 * arm + shared + arm_effect[arm] + random.normal(0, 0.02)
                rows.append((launch, block, arm, float(f"{value:.12g}")))
    rows = [row for i, row in enumerate(rows) if i not in gaps]
    return pandas.DataFrame(rows, columns=["launch", "block", "arm", "y"])


def contrasts(fit):
    for first in range(ARMS):
        for second in range(first + 1, ARMS):
            weights = np.zeros(len(fit.params))
            for arm, sign in ((first, -1), (second, 1)):
                if arm > 0:
                    weights[list(fit.params.index).index(f"C(arm)[T.{arm}]")] = sign
            test = fit.t_test(weights)
            yield first, second, test.effect.item(), test.sd.item(), fit.df_resid, test.pvalue.item()


def write_blocks(out, name, data, mixed):
    print("blocks", name, file=out)
    for row in data.itertuples():
        print("value", row.launch, row.block, row.arm, repr(row.y), file=out)
    if data.launch.nunique() == 1:
        fit = smf.ols("y ~ C(arm) + C(block)", data).fit()
    else:
        effects = []
        for launch, part in data.groupby("launch"):
            inner = smf.ols("y ~ C(arm) + C(block)" if part.block.nunique() > 1 else "y ~ C(arm)", part).fit()
            for arm in sorted(part.arm.unique()):
                effects.append((launch, arm, inner.params.get(f"C(arm)[T.{arm}]", 0.0)))
        frame = pandas.DataFrame(effects, columns=["launch", "arm", "y"])
        fit = smf.ols("y ~ C(arm) + C(launch)", frame).fit()
    for first, second, estimate, error, degrees, p in contrasts(fit):
        print("contrast", first, second, repr(estimate), repr(error), int(degrees), repr(p), file=out)
    if mixed:
        data = data.assign(unique=data.launch * 100 + data.block)
        model = smf.mixedlm("y ~ C(arm) + C(unique)", data, groups="launch", re_formula="0",
                            vc_formula={"arm": "0 + C(arm)"})
        fit = model.fit(reml=True, method=["bfgs", "powell"])
        for arm in range(1, ARMS):
            key = f"C(arm)[T.{arm}]"
            print("mixed", 0, arm, repr(fit.fe_params[key]), repr(fit.bse_fe[key]), file=out)


def write_effects(out, name, y, se):
    y, se = np.array(y), np.array(se)
    k = len(y)

    def parts(tau2):
        w = 1 / (se**2 + tau2)
        mean = np.sum(w * y) / np.sum(w)
        return w, mean

    def deviance(tau2):
        w, mean = parts(tau2)
        return -np.sum(np.log(w)) + np.log(np.sum(w)) + np.sum(w * (y - mean) ** 2)

    best = optimize.minimize_scalar(deviance, bounds=(0, 10 * np.var(y) + 1e-12), method="bounded",
                                    options={"xatol": 1e-16, "maxiter": 5000}).x
    tau2 = 0.0 if deviance(0.0) <= deviance(best) else best
    w, mean = parts(tau2)
    scale = np.sum(w * (y - mean) ** 2) / (k - 1)
    error = np.sqrt(max(1.0, scale) / np.sum(w))
    t = stats.t.ppf(0.975, k - 1)
    wide = t * np.sqrt(tau2 + error**2)
    print("effects", name, file=out)
    for one, its in zip(y, se):
        print("machine", repr(float(one)), repr(float(its)), file=out)
    print("pooled", *(repr(float(v)) for v in (tau2, mean, error, mean - t * error, mean + t * error, mean - wide, mean + wide)),
          file=out)


with open(sys.argv[1] if len(sys.argv) > 1 else "sweep_models.txt", "w") as out:
    print("# Written by make_sweep_models.py, which says what the lines are.", file=out)
    write_blocks(out, "one-launch", draw(1, 5, (), 0.0), False)
    write_blocks(out, "one-launch-with-gaps", draw(1, 5, (0, 6, 13), 0.0), False)
    write_blocks(out, "five-launches", draw(5, 3, (), 0.03), True)
    write_blocks(out, "five-launches-of-one-block", draw(5, 1, (), 0.03), False)
    write_blocks(out, "five-launches-with-gaps", draw(5, 3, (2, 17, 30, 31, 59), 0.03), False)
    write_effects(out, "three-machines", [0.08, 0.15, 0.02], [0.010, 0.020, 0.015])
    write_effects(out, "six-machines", [0.11, 0.19, 0.05, 0.14, 0.09, 0.30], [0.02, 0.05, 0.01, 0.04, 0.02, 0.08])
    write_effects(out, "no-difference", [0.100, 0.101, 0.099, 0.1005], [0.01, 0.02, 0.015, 0.01])
