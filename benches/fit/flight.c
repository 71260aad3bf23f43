/* Flights by the classic Runge-Kutta method, with their sensitivities; the equations are SymPy's, set before this file. */

static void combine(double* to, const double* x, double h, const double* d, int n) {
  for (int i = 0; i < n; i++) to[i] = x[i] + h * d[i];
}

static void step(const double* p, double* x, double h) {
  double k1[NX], k2[NX], k3[NX], k4[NX], at[NX];
  motion(x, p, k1);
  combine(at, x, h / 2, k1, NX); motion(at, p, k2);
  combine(at, x, h / 2, k2, NX); motion(at, p, k3);
  combine(at, x, h, k3, NX);     motion(at, p, k4);
  for (int i = 0; i < NX; i++) x[i] += h / 6 * (k1[i] + 2 * (k2[i] + k3[i]) + k4[i]);
}

/* The state and S = d state / d (coefficients, initial state), row by row. */
typedef struct { double x[NX]; double S[NX][WIDTH]; } Both;
enum { ALL = NX + NX * WIDTH };

static void rate(const double* p, const Both* at, Both* d) {
  double o[LINEAR];
  linear(at->x, p, o);
  for (int i = 0; i < NX; i++) d->x[i] = o[i];
  add_product(o, at->S, d->S);
}

static void step_both(const double* p, Both* now, double h) {
  Both k1, k2, k3, k4, at;
  double *x = now->x, *a = at.x;
  rate(p, now, &k1);
  combine(a, x, h / 2, k1.x, ALL); rate(p, &at, &k2);
  combine(a, x, h / 2, k2.x, ALL); rate(p, &at, &k3);
  combine(a, x, h, k3.x, ALL);     rate(p, &at, &k4);
  for (int i = 0; i < ALL; i++) x[i] += h / 6 * (k1.x[i] + 2 * (k2.x[i] + k3.x[i]) + k4.x[i]);
}

void fly(int flights, int samples, int substeps, double interval, const double* p, const double* start, double* states) {
#pragma omp parallel for schedule(dynamic)
  for (int f = 0; f < flights; f++) {
    double x[NX];
    for (int i = 0; i < NX; i++) x[i] = start[f * NX + i];
    for (int s = 0; s < samples; s++) {
      for (int k = 0; k < (s ? substeps : 0); k++) step(p, x, interval / substeps);
      for (int i = 0; i < NX; i++) states[((long)f * samples + s) * NX + i] = x[i];
    }
  }
}

void markers(int states, const double* x, int marks, const double* mark, double* y) {
  for (long s = 0; s < states; s++)
    for (int m = 0; m < marks; m++) {
      double o[12];
      shown(x + s * NX, mark + 3 * m, o);
      for (int i = 0; i < 3; i++) y[(s * marks + m) * 3 + i] = o[i];
    }
}

void residuals(int flights, int samples, int substeps, double interval, const double* p, const double* start,
               int marks, const double* mark, const double* seen, double scale, double* r) {
#pragma omp parallel for schedule(dynamic)
  for (int f = 0; f < flights; f++) {
    double x[NX], o[12];
    for (int i = 0; i < NX; i++) x[i] = start[f * NX + i];
    for (int s = 0; s < samples; s++) {
      for (int k = 0; k < (s ? substeps : 0); k++) step(p, x, interval / substeps);
      for (int m = 0; m < marks; m++) {
        long at = (((long)f * samples + s) * marks + m) * 3;
        shown(x, mark + 3 * m, o);
        for (int i = 0; i < 3; i++) r[at + i] = (o[i] - seen[at + i]) * scale;
      }
    }
  }
}

void jacobian(int flights, int samples, int substeps, double interval, const double* p, const double* start,
              int marks, const double* mark, const double* seen, double scale, double* r, double* J) {
#pragma omp parallel for schedule(dynamic)
  for (int f = 0; f < flights; f++) {
    Both now = {0};
    double o[12];
    for (int i = 0; i < NX; i++) now.x[i] = start[f * NX + i], now.S[i][NC + i] = 1;
    for (int s = 0; s < samples; s++) {
      for (int k = 0; k < (s ? substeps : 0); k++) step_both(p, &now, interval / substeps);
      for (int m = 0; m < marks; m++) {
        long at = (((long)f * samples + s) * marks + m) * 3;
        shown(now.x, mark + 3 * m, o);
        for (int i = 0; i < 3; i++) {
          const double* turn = o + 3 + 3 * i;
          double* row = J + (at + i) * WIDTH;
          r[at + i] = (o[i] - seen[at + i]) * scale;
          for (int j = 0; j < WIDTH; j++)
            row[j] = scale * (now.S[i][j] + turn[0] * now.S[6][j] + turn[1] * now.S[7][j] + turn[2] * now.S[8][j]);
        }
      }
    }
  }
}
