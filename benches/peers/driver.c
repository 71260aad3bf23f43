/* Times functions of shared libraries, interleaved: every round calls each of them `calls` times over the same states.

   driver LIST STATES ROUNDS CALLS
   LIST has a library and a symbol a line; STATES is 30 doubles a state. One line of nanoseconds per call and round each. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

typedef void (*function)(const double*, const double*, double*);

static double now(void) {
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return 1e9 * t.tv_sec + t.tv_nsec;
}

int main(int argc, char** argv) {
  static function functions[4096];
  static double states[1 << 16], out[512];
  char library[4096], symbol[512];
  int n = 0;
  if (argc != 5) return 2;
  FILE* list = fopen(argv[1], "r");
  while (list && n < 4096 && fscanf(list, "%4095s %511s", library, symbol) == 2) {
    void* handle = dlopen(library, RTLD_NOW | RTLD_LOCAL);
    functions[n] = handle ? (function)dlsym(handle, symbol) : 0;
    if (!functions[n++]) return fprintf(stderr, "%s: %s\n", symbol, dlerror()), 1;
  }
  FILE* file = fopen(argv[2], "rb");
  int count = file ? (int)(fread(states, sizeof(double), 1 << 16, file) / 30) : 0;
  int rounds = atoi(argv[3]), calls = atoi(argv[4]);
  if (!count) return 2;
  for (int round = 0; round < rounds; round++) {
    for (int i = 0; i < n; i++) {
      function f = functions[i];
      for (int k = 0; k < 200; k++) f(states + 30 * (k % count), states + 30 * (k % count) + 12, out);
      double start = now();
      for (int k = 0, s = 0; k < calls; k++, s = s + 1 == count ? 0 : s + 1) f(states + 30 * s, states + 30 * s + 12, out);
      printf("%.3f ", (now() - start) / calls);
    }
    printf("\n");
  }
  return 0;
}
