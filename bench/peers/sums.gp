\\ SPDX-License-Identifier: GPL-3.0-or-later
\\ The sums of powers in PARI/GP. go(WAY, TIMES) and show(WAY) answer with a line "=done".
highest = 50;

\\ PARI's own function; it keeps Bernoulli's numbers from one round to the next.
summed() = vector(highest, m, (bernpol(m + 1, n) - bernfrac(m + 1)) / (m + 1));

\\ The recurrence of faulhaber.hpp, on PARI's polynomials.
integrated() =
{
  my(s = n);
  vector(highest, m, s = intformal(m * s, n); s -= subst(s, n, 1) * n)
}

sums(way) = if (way == 1, summed(), integrated());
go(way, times) = { for (i = 1, times, sums(way)); print("=done") }
show(way) =
{
  foreach(sums(way), s, my(text = ""); foreach(Vecrev(s), c, text = Str(text, c, " ")); print(text));
  print("=done")
}
{ my(v = version()); print("PARI/GP ", v[1], ".", v[2], ".", v[3]); print("=done") }
