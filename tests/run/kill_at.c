/* SPDX-License-Identifier: Apache-2.0 */
/* Preloaded into a run: ends it as kill -9 does, right before the call number KILL_AT of those that change the names of
   files. They are counted from the rename of OUT/.new on, which is number 1. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static int seen, begun;

static int ends_with(const char* text, const char* end) {
  size_t a = strlen(text), b = strlen(end);
  return a >= b && strcmp(text + a - b, end) == 0;
}

static void count(void) {
  const char* at = getenv("KILL_AT");
  if (begun && at && ++seen == atoi(at)) kill(getpid(), SIGKILL);
}

#define NEXT(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

int rename(const char* from, const char* to) {
  if (ends_with(from, "/.new")) begun = 1;
  count();
  return NEXT(rename)(from, to);
}
int remove(const char* path) {
  count();
  return NEXT(remove)(path);
}
int rmdir(const char* path) {
  count();
  return NEXT(rmdir)(path);
}
int unlink(const char* path) {
  count();
  return NEXT(unlink)(path);
}
int unlinkat(int folder, const char* path, int flags) {
  count();
  return NEXT(unlinkat)(folder, path, flags);
}
int mkdir(const char* path, mode_t mode) {
  count();
  return NEXT(mkdir)(path, mode);
}
