#!/usr/bin/env python3
"""Writes cost_models.txt, the numbers that the cost against rate with the launch as a random effect is checked against, with
statsmodels (Debian 12: python3-statsmodels 0.13.5). The tests read the file; they need no Python.

cost NAME        cost = a + b frames + c wake-ups + launch + error, all per second, the costs in ns
run L LOAD FRAMES WAKE_UPS COST       a run of launch L, under a load
fit A B C ERROR_A ERROR_B ERROR_C     coefficients and standard errors by REML (statsmodels MixedLM)
deviation WITHIN BETWEEN              standard deviations of the errors and of the launches
"""
import sys
import numpy as np
import statsmodels.api as sm

UNIT = np.array([1.0, 1e3, 1e2])  # of the columns and, below, of the costs, so that the optimiser sees numbers near 1
COST = 1e6
random = np.random.default_rng(20261126)


def drawn(launches, repeats, launch_sd, run_sd):
    rows = []
    for launch in range(launches):
        shared = random.normal(0, launch_sd)
        for load, (frames, wake_ups) in enumerate(((160, 150), (560, 250), (2060, 258), (5060, 262))):
            for _ in range(repeats):
                ups = round(wake_ups + random.normal(0, 4))
                cost = 700000 + 2600 * frames + 19000 * ups + shared + random.normal(0, run_sd)
                rows.append((launch, load, frames, ups, round(cost)))
    return rows


def write(out, name, rows):
    print("cost", name, file=out)
    for row in rows:
        print("run", *row, file=out)
    data = np.array(rows, dtype=float)
    design = np.column_stack([np.ones(len(data)), data[:, 2], data[:, 3]]) / UNIT
    model = sm.MixedLM(data[:, 4] / COST, design, groups=data[:, 0])
    best = None
    for method in ("bfgs", "powell", "nm"):
        fit = model.fit(reml=True, method=method, gtol=1e-12, xtol=1e-14, ftol=1e-14, maxiter=20000, disp=False)
        if best is None or fit.llf > best.llf:
            best = fit
    print("fit", *(repr(float(v)) for v in best.fe_params * COST / UNIT), *(repr(float(v)) for v in best.bse_fe * COST / UNIT),
          file=out)
    print("deviation", repr(float(np.sqrt(best.scale)) * COST), repr(float(np.sqrt(best.cov_re[0, 0])) * COST), file=out)


with open(sys.argv[1] if len(sys.argv) > 1 else "cost_models.txt", "w") as out:
    print("# Written by make_cost_models.py, which says what the lines are.", file=out)
    write(out, "five-launches", drawn(5, 1, 300000, 60000))
    write(out, "five-launches-of-three-runs", drawn(5, 3, 150000, 90000))
    ragged = drawn(6, 2, 400000, 80000)
    write(out, "six-launches-with-gaps", [row for i, row in enumerate(ragged) if i not in (3, 8, 9, 25, 41)])
