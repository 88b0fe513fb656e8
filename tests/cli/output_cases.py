# SPDX-License-Identifier: GPL-3.0-or-later
"""The commands whose JSON is held against share/output: every writer, every branch of it that can be reached.

CASES  a line a command: its exit code, then its words as a shell reads them, without --json
FILES  what the commands read; examples, scenes and tests of the repository stand beside them
"""

DATA = "tests/data"

#: Steps that damp without naming an equation, ignore the launch in their first frame, have a coefficient that depends on t,
#: carry something that is singular or grows where the motion does not; steps with mistakes; frames; tableaus.
FILES = {
    "mine.integrator": "integrator mine\n  param c : 1/T = 1/10\n"
                       "step\n  v = (v + h*a(x, v, t))*(1 - c*h)\n  x = x + h*v\n",
    "wrong.integrator": "integrator wrong\n  source nobody\nstep\n  v = v + h/2*a(x, v, t)\n  x = x + h*v\nexpect\n  order 1\n  symmetric\n",
    "still.integrator": "integrator still\n  source nobody\nstep\n  x = x + h*v\n",
    "late.integrator": "integrator late\n  state w : L/T\nstart\n  w = 0*v\nstep\n  x = x + h*w\n  w = v\n  v = v + h*a(x, v, t)\n",
    "timed.integrator": "integrator timed\n  param c : 1/T^2 = 1/10\nstep\n  v = v + h*a(x, v, t) - c*t*h*v\n  x = x + h*v\n",
    "singular.integrator": "integrator singular\n  state w : L/T^2\nstart\n  w = a(x, v, t)\nstep\n  solve k : L/T^2 = a(x - h^2*k, v, t)\n"
                           "  w = k\n  v = v + h*a(x, v, t)\n  x = x + h*v\n",
    "growing.integrator": "integrator growing\n  state s : L\nstart\n  s = x\nstep\n  s = x - s\n  v = v + h*a(x, v, t)\n  x = x + h*v\n",
    "frames.csv": "dt [ms]\n16.7\n16.6\n50\n16.7\n",
    "stamps.csv": "frame,time [s]\n0,0\n1,0.1\n2,0.2\n3,0.3\n4,0.4\n5,0.5\n6,0.6\n",
    "rates.csv": "fps\n60\n59\n30\n",
    "sdirk.json": '{"A": [[0.211324865405187, 0], [0.577350269189626, 0.211324865405187]], "b": [0.5, 0.5], '
                  '"c": [0.211324865405187, 0.788675134594813], "order": 3}',
    "stage.json": '{"name": "implicit-euler", "A": [[1]], "b": [1]}',
    "nystroem.json": '{"name": "own", "kind": "nystroem", "Abar": [[]], "b": [1], "bbar": ["1/2"], "c": [0], "order": 1}',
}


def motion(rows, step, row, v=10.0, after=lambda n, y, v: (y, v)):
    """A log of a body that falls from 0 with v upwards, its lines written by `row(t, y, v)`; `after` changes a step."""
    lines, y = [], 0.0
    for n in range(rows):
        lines.append(row(n * step, y, v))
        v = v - step * 9.81
        y, v = after(n, y + step * v, v)
    return "\n".join(lines) + "\n"


def _row(t, y, v):
    return f"{t:.12g},{y:.17g},{v:.17g}"


FILES |= {
    "fall.csv": "time,y,vy\n" + motion(60, 0.02, _row),
    "fall.jsonl": motion(60, 0.02, lambda t, y, v: f'{{"t": {t:.12g}, "position": [0, {y:.17g}, 0]}}'),
    "centimetres.csv": "time,y\n" + motion(60, 0.02, lambda t, y, v: f"{t:.2f},{y:.2f}"),
    "few.csv": "time,y\n" + motion(4, 0.02, lambda t, y, v: f"{t:.2f},{y:.4f}"),
    "bounce.csv": "time,y,vy\n" + motion(150, 0.02, _row, after=lambda n, y, v: (-0.5, -0.5 * v) if y < -0.5 else (y, v)),
    "moved.csv": "time,y,vy\n" + motion(120, 0.02, _row, after=lambda n, y, v: (y + 0.3 * (n == 60), v)),
    "limited.csv": "time,y,vy\n" + motion(150, 0.02, _row, 5.0, lambda n, y, v: (y - 0.02 * (v + 7), -7.0) if v < -7 else (y, v)),
    "noise.csv": "time,y,vy\n" + "".join(f"{n * 0.02:.12g},{(n * n * 7919) % 101},{(n * 31) % 17}\n" for n in range(40)),
}

_SCENE = ('title = "An oscillator"\nuntil = 2\ndt = 0.1\nnaive = "symplectic-euler"\n[[body]]\nposition = 1\n[[force]]\nname = "spring"\n'
          'kind = "spring"\nstiffness = 1\n[[force]]\nname = "breath"\nkind = "constant"\nacceleration = 1e-9\n'
          '[[observable]]\nkind = "position"\ntolerance = {}\n[budget]\nformats = [{}]\n')
FILES["scene.toml"] = _SCENE.format("2e-3", '"f32", "f64"')
FILES["strict.toml"] = _SCENE.format("1e-9", '"f32"')
FILES["landing.toml"] = ('until = 5\ndt = 0.02\n[[body]]\nposition = 1\n[[force]]\nname = "gravity"\nkind = "constant"\nacceleration = -9.81\n'
                         '[[event]]\nname = "ground"\naxis = "x"\nlevel = 0\ndirection = "down"\nends = true\n'
                         '[[observable]]\nkind = "event-time"\nevent = "ground"\ntolerance = 1e-2\n')
FILES["exploding.toml"] = ('until = 2400\ndt = 1\n[[body]]\nposition = 1\n[[force]]\nkind = "spring"\nstiffness = 1\n'
                           '[[observable]]\nkind = "energy-drift"\ntolerance = 0.1\n')
FILES["kepler.toml"] = ('until = 10\ndt = 0.1\ndimension = 2\n[[body]]\nposition = [1, 0]\nvelocity = [0, 1]\n[[force]]\nkind = "kepler"\nmu = 1\n'
                        '[[observable]]\nkind = "energy-drift"\ntolerance = 1e-3\n')

CASES = f"""
0 --version
0 list
0 list engines
0 export --lessons

0 show symplectic-euler
0 show rapier@0.21
0 show yoshida4
1 show wrong.integrator

0 jump --height 40cm --dt 0.02
0 jump velocity-verlet --height 1.7 --dt 50Hz
0 jump symplectic-euler --height 1.7m --substeps 4
0 jump --height 1mm
0 jump --height 1.962mm
0 jump drift-kick --height 1mm
0 jump explicit-euler --height 40cm
0 jump --height 1mm:100m:log:5
0 jump --height 1:2:lin:3 --dt 1/60f
0 jump godot --height 10m --param c=0.1
0 jump bullet --height 1.7 --param c=0.1
0 jump rapier --height 1.7 --substeps 8
0 jump rapier --height 1.7 --launch force:5
0 jump physx --height 1.7 --launch impulse
0 jump physx-tgs-external-forces --height 1.7 --launch impulse
0 jump box2d-2 --height 600
0 jump box2d-2 --height 30km
0 jump godot --height 10m --param c=0.1 --launch force
0 jump mine.integrator --height 1
0 jump mine.integrator --height 1 --param c=80
0 jump mine.integrator --height 1 --param c=80 --launch force
0 jump box2d-2 --height 100m --dt 1e-6
0 jump AB2 --height 1
0 jump rk4 --height 1e6 --dt 1e-4
0 jump --height 1e40 --dt 1e-9
0 jump cannon-es --height 1.7 --param c=0.5
0 jump beeman --height 0.5
0 jump --all-engines --height 1.7
0 jump --all-engines --height 1.7 --launch force
0 jump --height 40cm --dt-file frames.csv --repeat
0 jump --height 1.7 --dt-file examples/frames.csv
0 jump velocity-verlet --height 40cm --dt-file frames.csv --repeat
0 jump AB2 --height 40cm --dt-file frames.csv --repeat
0 jump explicit-euler --height 1 --dt-file stamps.csv
0 jump --height 1mm --dt-file rates.csv --repeat
0 jump beeman --height 40cm --dt-file frames.csv --repeat
0 jump late.integrator --height 1 --dt-file frames.csv --repeat

0 derive symplectic-euler --force constant
0 derive symplectic-euler --substeps 4
0 derive newmark --force poly:1 --param beta=1/6
0 derive explicit-euler --force poly:2
0 derive velocity-verlet
0 derive yoshida4 --force poly:1
0 derive pefrl
0 derive ode
0 derive rk4 --force poly:31
0 derive velocity-verlet --force spring
0 derive explicit-euler --force spring --substeps 2
0 derive rk4 --force damped-spring
0 derive AB2 --force drag
0 derive symplectic-euler --force constant+spring:k=4
0 derive symplectic-euler --force poly:1+spring
0 derive godot --force drag
0 derive AB2 --force spring
0 derive pefrl --force spring
0 derive chipmunk --force spring
0 derive still.integrator --force spring
0 derive gauss4 --force spring:k=4
0 derive velocity-verlet --force spring:k=1 --dt 1/10 --steps 1e18 --x0 1
0 derive velocity-verlet --force spring:k=1 --dt 1/10 --until 0.5 --x0 1m --substeps 2
0 derive symplectic-euler --steps 100 --v0 3
0 derive bullet --param c=1/10 --force constant:a=0 --steps 10 --v0 1
0 derive bullet --param c=1/10 --force constant:a=0 --steps 10
0 derive gauss4 --force drag:c=1 --steps 1e4 --v0 3
0 spring symplectic-euler --k 10000 --dt 1/50
0 spring symplectic-euler --k 1 --c 2 --dt 1
0 derive symplectic-euler --force constant:a=0+spring:k=2 --dt 1 --steps 1000001 --x0 0

0 correct symplectic-euler --force constant
0 correct symplectic-euler --force poly:2
0 correct explicit-euler --force poly:2
0 correct velocity-verlet --force constant
0 correct velocity-verlet --force poly:3 --substeps 2
0 correct symplectic-euler --force spring:k=40 --dt 1/60
0 correct rk4 --force spring:k=4 --dt 1/10
0 correct rk4 --force drag
0 correct heun --force drag
4 correct ode --force constant
0 correct chipmunk --force spring
4 correct still.integrator --force spring
0 correct half-gravity --force spring:k=16 --dt 1 --substeps 2
0 correct rk4 --force damped-spring
4 correct rk4 --force drag:c=4 --dt 1/2
0 correct gauss4 --force spring
0 correct symplectic-euler --force poly:1+spring
0 correct symplectic-euler --force constant+damped-spring:k=4,c=1 --substeps 2
0 correct AB2 --force spring:k=4
0 correct symplectic-euler --force general
4 correct explicit-euler --force general
0 correct velocity-verlet --force general --order 4
0 correct velocity-verlet --force "a(x, t)" --order 4
4 correct velocity-verlet --force "a(x, t)" --order 6
4 correct leapfrog --force general
4 correct heun --force general
4 correct pefrl --force position-only

0 verify symplectic-euler --force constant --x "x0 + v0*t + 1/2*a*t^2 + 1/2*a*h*t"
1 verify explicit-euler --force constant --x "x0 + v0*t + 1/2*a*t^2 + 1/2*a*h*t"
0 verify rk4 --force poly:1 --v "v0 + f0*t + 1/2*f1*t^2"
1 verify adams-bashforth-2 --force poly:1 --x "x0 + v0*t + 1/2*f0*t^2 + 1/6*f1*t^3 - 5/12*f1*h^2*t + 1/4*f1*h^3"
0 verify symplectic-euler --x "x0 + v0*t + 1/2*a*t^2*(n + 1)/n"
1 verify rk4 --force poly:1 --x "x0 + v0*t" --v "v0 + f0*t + 1/2*f1*t^2"

0 stability symplectic-euler
0 stability newmark --param beta=0 --param gamma=1/2
0 stability newmark
0 stability rk4
0 stability implicit-euler
0 stability explicit-euler
0 stability gauss4
0 stability velocity-verlet --substeps 4
0 stability cannon-es --param c=0.1 --dt 60Hz
0 stability forest-ruth
0 stability AB2
0 stability bullet --param c=0.1 --dt 60Hz
0 stability symplectic-euler --substeps 12
0 stability generalised-alpha
0 stability radau-iia-3
0 stability sdirk.json
0 stability beeman
0 stability implicit-midpoint
0 stability trapezoidal --substeps 2
0 stability position-verlet
0 stability singular.integrator
0 stability growing.integrator
0 stability mclachlan-atela-2
0 stability {DATA}/methods/ark4-3-6l2sa-erk.json
0 stability {DATA}/methods/merson-4.json

0 order forest-ruth
0 order dormand-prince
0 order {DATA}/methods/fehlberg-45.json
0 order pefrl
0 order pefrl --force separable
0 order mclachlan-atela-4 --force "a(x, t)"
0 order newmark
0 order stoermer-verlet-wrong-start
0 order wrong.integrator
4 order gauss6 --max-memory 20kB
0 order gauss4
0 order implicit-midpoint
0 order nystroem.json
0 order trapezoidal
0 order sdirk.json --highest 5
0 order velocity-verlet --force "a(t)" --highest 4

0 modified symplectic-euler --order 4 --hamiltonian
0 modified midpoint --order 5 --modifying
0 modified velocity-verlet --force "a(x, t)"
4 modified rk4 --hamiltonian --order 6
4 modified symplectic-euler --modifying
4 modified velocity-verlet --modifying --force "a(x)"
0 modified pefrl --order 6 --hamiltonian
0 modified rk4

0 portrait symplectic-euler --dt 1/2 --from 1,0 --from 1/2,-1 --steps 20
0 portrait rk4 --steps 10
0 portrait symplectic-euler --potential "-x^4"
0 portrait symplectic-euler --potential "log(x)" --dt 1/4 --steps 8
0 portrait velocity-verlet --potential "1 - cos(x)" --steps 10 --substeps 2
0 portrait symplectic-euler --potential "sqrt(x)" --from 1,-1 --steps 100

0 audit {DATA}/methods/dormand-prince-54.json
0 audit {DATA}/methods/tsitouras-54.json
0 audit {DATA}/methods/nystroem-rkn4.json
1 audit {DATA}/misprints/cash-karp-swapped.json
1 audit {DATA}/misprints/cash-karp-two-mistakes.json
1 audit {DATA}/misprints/cash-sdirk-4-3-gamma.json
1 audit {DATA}/misprints/ark3-2-4l2sa-esdirk-numerator-digits.json
1 audit {DATA}/misprints/heun3-claim.json
1 audit {DATA}/misprints/rk4-column.json
1 audit {DATA}/misprints/gauss6-exchanged.json
1 audit {DATA}/misprints/kvaerno-3-2-decimal-digits.json
1 audit {DATA}/misprints/bogacki-shampine-32-decimal.json
1 audit {DATA}/misprints/ruth3-sign.integrator
1 audit {DATA}/misprints/velocity-verlet-old-force.integrator --order 2
1 audit {DATA}/misprints/mclachlan-atela-4-exchanged.integrator --order 4
4 audit {DATA}/methods/prince-dormand-87-13m.json --max-memory 20kB
1 audit {DATA}/methods/kutta3.json --order 4
0 audit sdirk.json
1 audit wrong.integrator
0 audit velocity-verlet

0 budget --height 1.7
0 budget symplectic-euler --height 1.7 --dt 0.02f --landing --formats f16,f32,f64,mpfr:40
0 budget velocity-verlet --force spring:k=40 --dt 1/60f --periods 2 --formats bf16+kahan,f32,f64
0 budget symplectic-euler --force spring:k=1 --dt 1/10 --steps 100 --formats f32,f64+tozero,x87,f128,dd,f32+fma,f32+origin
0 budget velocity-verlet --force constant:a=-8 --dt 1/64 --v0 5/2 --steps 100
0 budget gauss4 --force damped-spring:k=9,c=1/2 --dt 1/30 --until 1 --formats f64
0 budget explicit-euler --force spring:k=1000 --dt 1 --steps 500 --formats f32,f64
0 budget box2d-2 --force spring:k=4 --steps 10
0 budget rk4 --force drag:a=-9.81,c=1/10 --steps 20 --formats f16
4 budget timed.integrator --force spring:k=4 --steps 5 --formats f32

0 clock --dt 0.1f --steps 1e6
0 clock --dt 1/60f --until 24h
0 clock --dt 0.1 --until 100h --format fixed:23 --rounding toward-zero
0 clock --dt 0.02 --velocity 3 --x0 10km --until 1h
0 clock --dt 1/60f --until 24h --kahan
0 clock --dt 0.1f --steps 1e12 --kahan
0 clock --dt 0.1f --steps 6e6 --format f32+kahan
0 clock --dt 0.1 --steps 1e30 --format f64 --rounding up
0 clock --dt=-0.1 --x0 1 --steps 20 --format f16
0 clock --dt 0.1d --steps 3 --rounding nearest-away
0 clock --dt 1/64 --steps 100 --format f32+fma --rounding down
0 clock --dt 0.1 --steps 1e4 --format fixed:20
0 clock --dt 0.3 --steps 0 --format mpfr:10
0 clock --dt 0.1 --steps 10 --format f128 --rounding up
0 clock --dt 0.1 --steps 1e5 --format bf16 --kahan

0 cycle symplectic-euler --force spring:k=1 --dt 1/8 --formats f16
4 cycle --most 10
4 cycle explicit-euler --force spring:k=1 --dt 1 --formats f16
0 cycle implicit-euler --force spring:k=1 --dt 1/8 --formats f16
4 cycle symplectic-euler --force damped-spring:k=1,c=1/10 --formats bf16,f16+tozero --most 1e4

0 extremes
0 extremes velocity-verlet --formats f32,f16

0 trade scene.toml --integrators symplectic-euler,velocity-verlet,rk4 --repeats 1
0 trade scene.toml --integrators rk4 --formats f64 --repeats 0 --no-peers --no-launches
0 trade scene.toml --integrators velocity-verlet --formats f64 --repeats 1 --no-peers --lanes 8
0 trade strict.toml --integrators symplectic-euler,explicit-euler --repeats 0 --no-peers
0 trade kepler.toml --integrators velocity-verlet,symplectic-euler --formats f64 --repeats 0 --dt 0.05:0.4:log:3

0 trade kepler.toml --integrators rk4 --formats f64 --repeats 1 --no-peers --no-launches --lanes 4
0 trade exploding.toml --integrators explicit-euler --repeats 0 --no-peers --no-launches --dt 2:20:log:3
0 advise scene.toml --integrators symplectic-euler,velocity-verlet
1 advise strict.toml
0 advise scenes/jump.toml --margin 4
0 advise landing.toml

0 damping godot --param c=0.5 --dt 60Hz
0 damping bullet --param c=0.5
0 damping ode --param c=1 --dt 1
0 damping ode --param c=2 --dt 1
0 damping rapier --param c=0.5 --substeps 8
0 damping mine.integrator --substeps 2
0 damping --all-engines --param c=0.5 --dt 60Hz

0 spring symplectic-euler --frequency 2Hz --damping-ratio 0 --dt 60Hz
0 spring rapier --k 40 --c 1 --dt 60Hz
0 spring symplectic-euler --frequency 2Hz --dt 60Hz --substeps 4 --held
0 spring explicit-euler --k 40 --c 20
0 spring rk4 --k 40000
0 spring rk4 --k 8 --dt 1
0 spring half-gravity --k 16 --dt 1 --substeps 2

0 identify fall.csv
0 identify centimetres.csv
0 identify fall.jsonl
0 identify few.csv
0 identify bounce.csv
0 identify moved.csv
0 identify limited.csv
1 identify noise.csv
0 identify {DATA}/recordings/rapier3d/velocity_v0.02_0_0_dt1-50_g0_d0_coast_sleep.csv
1 identify {DATA}/recordings/physx/spring_engine_d6_k40_c1_dt1-60_PGS.csv
1 identify {DATA}/recordings/physx/variable_dt_v1_6.csv
1 identify {DATA}/recordings/bullet/render_interpolated_h1.7_144Hz_fixed60.csv
0 identify {DATA}/recordings/cannon-es/impulse_h1.7_dt1-50_g9.81_d0.csv
0 identify --by-dt 30Hz:165px 60Hz:150px 120Hz:142.5px
0 identify {DATA}/recordings/rapier3d/force_v0_2_0_dt1-50_g9.81_d0.5.csv
0 identify {DATA}/recordings/box2d-v2.4/velocity_h400_dt1-30_g9.81_d0_maxtranslation.csv
0 identify {DATA}/recordings/physx/velocity_h1.7_dt1-50_g9.81_d0.5.csv
0 identify {DATA}/recordings/physx/impulse_h1.7_dt1-50_g9.81_d0.csv

0 port physx rapier --dt 60Hz --height 1.7 --param c=0.5
0 port jolt jolt --dt 60Hz --to-dt 120Hz --launch 5 --spring 4

0 guard fall.csv symplectic-euler
1 guard fall.csv jolt --substeps 2 --param c=0.3
1 guard noise.csv rapier
"""

#: What no case reaches, and why.
UNREACHED = {
    ("identify", "$defs", "parameters", "additionalProperties", "anyOf", 1, "properties", "spread", "type", "null"):
        "a fit without a spread takes a log that leaves a number open, and no such log is known",
    ("order", "properties", "energy_change", "properties", "order", "type", "null"):
        "no step keeps v^2/2 + V for every V",
    ("spring", "$defs", "effective", "properties", "stable", "type", "null"):
        "only a frame with roots or powers in it, exactly at its edge, is undecided",
    ("stability", "properties", "drag", "anyOf", 1):
        "no step is known that drag alone makes singular",
    ("trade", "properties", "observables", "items", "properties", "computations_differ_by", "type", "null"):
        "a scene whose true value is no number is refused",
    ("trade", "properties", "series", "items", "properties", "points", "items", "properties", "errors", "items", "type", "null"):
        "a run whose reading is no number has failed",
}
