/* SPDX-License-Identifier: Apache-2.0
 * The C interface of ilot for R: values of R in, values of R out. */
#include <ilot/ilot.h>
#include <math.h>
#include <pthread.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define R_NO_REMAP
#include <R.h>
#include <R_ext/Rdynload.h>
#include <Rinternals.h>

static void check(ilot_status status) {
  if (status != ILOT_OK && status != ILOT_INCOMPLETE) Rf_error("%s", ilot_last_error());
}

static const char* text_of(SEXP value) {
  return Rf_translateCharUTF8(STRING_ELT(value, 0));
}

/* A text of the library as R's, and given back. */
static SEXP text_taken(char* text) {
  SEXP made = PROTECT(Rf_ScalarString(Rf_mkCharCE(text, CE_UTF8)));
  ilot_free(text);
  UNPROTECT(1);
  return made;
}

static SEXP version_r(void) {
  return Rf_mkString(ilot_version());
}

/* ---- Clouds ---- */

static void close_cloud(SEXP handle) {
  ilot_cloud_close(R_ExternalPtrAddr(handle));
  R_ClearExternalPtr(handle);
}

/* R frees it also where an error leaves the function. */
static SEXP opened(SEXP path) {
  ilot_cloud* cloud = NULL;
  check(ilot_cloud_open(text_of(path), &cloud));
  SEXP handle = PROTECT(R_MakeExternalPtr(cloud, R_NilValue, R_NilValue));
  R_RegisterCFinalizerEx(handle, close_cloud, TRUE);
  UNPROTECT(1);
  return handle;
}

static SEXP integers_of(const uint16_t* values, size_t count) {
  SEXP made = Rf_allocVector(INTSXP, (R_xlen_t)count);
  for (size_t i = 0; i < count; ++i) INTEGER(made)[i] = values[i];
  return made;
}

static SEXP cut(SEXP values, size_t count) {
  return (size_t)XLENGTH(values) == count ? values : Rf_xlengthgets(values, (R_xlen_t)count);
}

/* list(X, Y, Z, Intensity, Classification, R, G, B) */
static SEXP read_cloud_r(SEXP path) {
  SEXP handle = PROTECT(opened(path));
  ilot_cloud* cloud = R_ExternalPtrAddr(handle);
  const size_t rows = (size_t)ilot_cloud_rows(cloud);
  SEXP made = PROTECT(Rf_allocVector(VECSXP, 8));
  for (int k = 0; k < 3; ++k) SET_VECTOR_ELT(made, k, Rf_allocVector(REALSXP, (R_xlen_t)rows));
  uint16_t* shorts = (uint16_t*)R_alloc(4 * (rows > 0 ? rows : 1), sizeof(uint16_t));
  uint8_t* classes = (uint8_t*)R_alloc(rows > 0 ? rows : 1, 1);
  ilot_columns columns = {REAL(VECTOR_ELT(made, 0)), REAL(VECTOR_ELT(made, 1)), REAL(VECTOR_ELT(made, 2)), shorts, classes,
                          shorts + rows,             shorts + 2 * rows,         shorts + 3 * rows};
  size_t points = 0;
  uint64_t read = 0;
  if (rows > 0) check(ilot_cloud_read(cloud, 0, rows, &columns, &read, &points));
  for (int k = 0; k < 3; ++k) SET_VECTOR_ELT(made, k, cut(VECTOR_ELT(made, k), points));
  SET_VECTOR_ELT(made, 3, integers_of(shorts, points));
  SEXP classification = PROTECT(Rf_allocVector(INTSXP, (R_xlen_t)points));
  for (size_t i = 0; i < points; ++i) INTEGER(classification)[i] = classes[i];
  SET_VECTOR_ELT(made, 4, classification);
  for (int k = 0; k < 3; ++k) SET_VECTOR_ELT(made, 5 + k, integers_of(shorts + (size_t)(k + 1) * rows, points));
  close_cloud(handle);
  UNPROTECT(3);
  return made;
}

static SEXP measure_r(SEXP path) {
  SEXP handle = PROTECT(opened(path));
  char* json = NULL;
  check(ilot_cloud_measure(R_ExternalPtrAddr(handle), &json));
  close_cloud(handle);
  UNPROTECT(1);
  return text_taken(json);
}

static uint16_t* shorts_of(SEXP values) {
  if (Rf_isNull(values)) return NULL;
  const R_xlen_t count = XLENGTH(values);
  uint16_t* made = (uint16_t*)R_alloc((size_t)(count > 0 ? count : 1), sizeof(uint16_t));
  for (R_xlen_t i = 0; i < count; ++i) made[i] = (uint16_t)INTEGER(values)[i];
  return made;
}

static void close_writer(SEXP handle) {
  ilot_writer_close(R_ExternalPtrAddr(handle));
  R_ClearExternalPtr(handle);
}

/* Lengths, types and ranges were checked by write_cloud(). */
static SEXP write_cloud_r(SEXP path, SEXP places, SEXP attributes, SEXP crs, SEXP scale) {
  ilot_columns columns = {REAL(VECTOR_ELT(places, 0)), REAL(VECTOR_ELT(places, 1)), REAL(VECTOR_ELT(places, 2)),
                          shorts_of(VECTOR_ELT(attributes, 0)), NULL, NULL, NULL, NULL};
  const size_t points = (size_t)XLENGTH(VECTOR_ELT(places, 0));
  SEXP classes = VECTOR_ELT(attributes, 1);
  if (!Rf_isNull(classes)) {
    columns.classification = (uint8_t*)R_alloc(points > 0 ? points : 1, 1);
    for (size_t i = 0; i < points; ++i) columns.classification[i] = (uint8_t)INTEGER(classes)[i];
  }
  columns.red = shorts_of(VECTOR_ELT(attributes, 2));
  columns.green = shorts_of(VECTOR_ELT(attributes, 3));
  columns.blue = shorts_of(VECTOR_ELT(attributes, 4));
  double offset[3] = {0, 0, 0};
  for (int k = 0; k < 3 && points > 0; ++k) offset[k] = floor(REAL(VECTOR_ELT(places, k))[0]);
  ilot_writer* writer = NULL;
  check(ilot_writer_open(text_of(path), text_of(crs), Rf_asReal(scale), offset,
                         columns.red != NULL || columns.green != NULL || columns.blue != NULL, &writer));
  SEXP handle = PROTECT(R_MakeExternalPtr(writer, R_NilValue, R_NilValue));
  R_RegisterCFinalizerEx(handle, close_writer, TRUE);
  check(ilot_writer_write(writer, points, &columns));
  check(ilot_writer_finish(writer));
  close_writer(handle);
  UNPROTECT(1);
  return R_NilValue;
}

/* ---- Whole runs ---- */

typedef struct {
  ilot_run* run;
  pthread_mutex_t mutex; /* of all below */
  int done, stop;
  ilot_status status;
  char stage[64], message[2048];
} run_state;

static int32_t note_progress(void* user, const char* stage, uint64_t done, uint64_t total, double seconds) {
  run_state* state = user;
  (void)done, (void)total, (void)seconds;
  pthread_mutex_lock(&state->mutex);
  strncpy(state->stage, stage, sizeof state->stage - 1);
  const int stop = state->stop;
  pthread_mutex_unlock(&state->mutex);
  return stop;
}

static void* work(void* user) {
  run_state* state = user;
  const ilot_status status = ilot_run_start(state->run);
  pthread_mutex_lock(&state->mutex);
  state->status = status;
  strncpy(state->message, ilot_last_error(), sizeof state->message - 1); /* that of this thread */
  state->done = 1;
  pthread_mutex_unlock(&state->mutex);
  return NULL;
}

/* Both may leave by longjmp, past the thread that still writes to run_state: they are called through R_ToplevelExec alone. */
static void look_for_interrupt(void* nothing) {
  (void)nothing;
  R_CheckUserInterrupt();
}

static void print_line(void* line) { Rprintf("%s\n", (const char*)line); }

/* Waits in R's thread. Ctrl-C stops this run at its next call of note_progress. */
static void wait_for(run_state* state, int verbose) {
  char shown[sizeof state->stage] = "";
  for (int done = 0; !done;) {
    const struct timespec tick = {0, 50 * 1000 * 1000};
    nanosleep(&tick, NULL);
    const int stop = !R_ToplevelExec(look_for_interrupt, NULL);
    pthread_mutex_lock(&state->mutex);
    if (stop) state->stop = 1;
    done = state->done;
    const int news = strcmp(shown, state->stage) != 0;
    strcpy(shown, state->stage);
    pthread_mutex_unlock(&state->mutex);
    if (news && verbose && !R_ToplevelExec(print_line, shown)) {
      pthread_mutex_lock(&state->mutex);
      state->stop = 1;
      pthread_mutex_unlock(&state->mutex);
    }
  }
}

static ilot_status configure(ilot_run* run, SEXP inputs, SEXP options, SEXP settings) {
  ilot_status status = ILOT_OK;
  for (R_xlen_t i = 0; status == ILOT_OK && i < XLENGTH(inputs); ++i)
    status = ilot_run_add_input(run, Rf_translateCharUTF8(STRING_ELT(inputs, i)));
  SEXP names = Rf_getAttrib(options, R_NamesSymbol);
  for (R_xlen_t i = 0; status == ILOT_OK && i < XLENGTH(options); ++i)
    status = ilot_run_set_option(run, Rf_translateCharUTF8(STRING_ELT(names, i)), Rf_translateCharUTF8(STRING_ELT(options, i)));
  for (R_xlen_t i = 0; status == ILOT_OK && i < XLENGTH(settings); ++i)
    status = ilot_run_set(run, Rf_translateCharUTF8(STRING_ELT(settings, i)));
  return status;
}

/* Returns the exit code: 0, or 3 where something was skipped. */
static SEXP run_r(SEXP inputs, SEXP options, SEXP settings, SEXP verbose) {
  run_state state;
  memset(&state, 0, sizeof state);
  pthread_mutex_init(&state.mutex, NULL);
  state.run = ilot_run_new();
  if (state.run == NULL) Rf_error("memory ran out");
  state.status = configure(state.run, inputs, options, settings);
  pthread_t thread;
  if (state.status != ILOT_OK) {
    strncpy(state.message, ilot_last_error(), sizeof state.message - 1);
  } else {
    ilot_run_set_callbacks(state.run, note_progress, NULL, &state);
    if (pthread_create(&thread, NULL, work, &state) != 0) {
      ilot_run_free(state.run);
      Rf_error("no thread can be made for the run");
    }
    wait_for(&state, Rf_asLogical(verbose));
    pthread_join(thread, NULL);
  }
  ilot_run_free(state.run);
  pthread_mutex_destroy(&state.mutex);
  if (state.status != ILOT_OK && state.status != ILOT_INCOMPLETE) Rf_error("%s", state.message);
  if (state.stop) Rf_error("interrupted; the run had ended by then, its results are whole"); /* else a loop over runs would go on */
  return Rf_ScalarInteger(state.status);
}

static SEXP parameters_r(void) {
  char* json = NULL;
  check(ilot_parameters(&json));
  return text_taken(json);
}

static SEXP read_result_r(SEXP what, SEXP folder) {
  static const struct {
    const char* name;
    ilot_status (*read)(const char*, char**);
  } readers[] = {{"run", ilot_read_run},
                 {"planes", ilot_read_planes},
                 {"roofs", ilot_read_roofs},
                 {"facades", ilot_read_facades},
                 {"streets", ilot_read_streets}};
  for (size_t i = 0; i < sizeof readers / sizeof readers[0]; ++i) {
    if (strcmp(readers[i].name, text_of(what)) != 0) continue;
    char* json = NULL;
    check(readers[i].read(text_of(folder), &json));
    return text_taken(json);
  }
  Rf_error("there is no result %s", text_of(what));
}

/* ---- Points in memory; x, y and z are doubles of one length. Indices of R begin at 1. ---- */

static SEXP indices_of(const uint32_t* values, size_t count, int missing_is_na) {
  SEXP made = Rf_allocVector(INTSXP, (R_xlen_t)count);
  for (size_t i = 0; i < count; ++i)
    INTEGER(made)[i] = missing_is_na && values[i] == ILOT_NO_POINT ? NA_INTEGER : (int)(values[i] + 1);
  return made;
}

static SEXP pair_of(SEXP one, SEXP two) {
  PROTECT(one);
  PROTECT(two);
  SEXP made = PROTECT(Rf_allocVector(VECSXP, 2));
  SET_VECTOR_ELT(made, 0, one);
  SET_VECTOR_ELT(made, 1, two);
  UNPROTECT(3);
  return made;
}

/* list(index, distance), `count` values a point */
static SEXP neighbours_r(SEXP x, SEXP y, SEXP z, SEXP count, SEXP most) {
  const size_t points = (size_t)XLENGTH(x), entries = points * (size_t)(Rf_asInteger(count) > 0 ? Rf_asInteger(count) : 1);
  uint32_t* index = (uint32_t*)R_alloc(entries + 1, sizeof(uint32_t));
  float* distance = (float*)R_alloc(entries + 1, sizeof(float));
  check(ilot_nearest_neighbours(REAL(x), REAL(y), REAL(z), points, Rf_asInteger(count), Rf_asReal(most), 0, index, distance));
  SEXP lengths = PROTECT(Rf_allocVector(REALSXP, (R_xlen_t)entries));
  for (size_t i = 0; i < entries; ++i) REAL(lengths)[i] = distance[i];
  SEXP made = pair_of(indices_of(index, entries, 1), lengths);
  UNPROTECT(1);
  return made;
}

/* list(normals, 3 values a point, and curvature) */
static SEXP normals_r(SEXP x, SEXP y, SEXP z, SEXP count, SEXP most) {
  const size_t points = (size_t)XLENGTH(x);
  float* normals = (float*)R_alloc(3 * points + 1, sizeof(float));
  float* curvature = (float*)R_alloc(points + 1, sizeof(float));
  check(ilot_estimate_normals(REAL(x), REAL(y), REAL(z), points, Rf_asInteger(count), Rf_asReal(most), 0, normals, curvature));
  SEXP directions = PROTECT(Rf_allocVector(REALSXP, (R_xlen_t)(3 * points)));
  SEXP bends = PROTECT(Rf_allocVector(REALSXP, (R_xlen_t)points));
  for (size_t i = 0; i < 3 * points; ++i) REAL(directions)[i] = normals[i];
  for (size_t i = 0; i < points; ++i) REAL(bends)[i] = curvature[i];
  SEXP made = pair_of(directions, bends);
  UNPROTECT(2);
  return made;
}

static SEXP clusters_r(SEXP x, SEXP y, SEXP z, SEXP radius) {
  const size_t points = (size_t)XLENGTH(x);
  uint32_t clusters = 0, *id = (uint32_t*)R_alloc(points + 1, sizeof(uint32_t));
  check(ilot_euclidean_clusters(REAL(x), REAL(y), REAL(z), points, Rf_asReal(radius), id, &clusters));
  return indices_of(id, points, 0);
}

/* list(label, planes): label 0 = none, else the number of the plane; 4 values a plane */
static SEXP planes_r(SEXP x, SEXP y, SEXP z, SEXP epsilon, SEXP angle, SEXP connectivity, SEXP least, SEXP seed) {
  const size_t points = (size_t)XLENGTH(x);
  uint32_t* label = (uint32_t*)R_alloc(points + 1, sizeof(uint32_t));
  double* planes = NULL;
  size_t count = 0;
  check(ilot_find_planes(REAL(x), REAL(y), REAL(z), points, Rf_asReal(epsilon), Rf_asReal(angle), Rf_asReal(connectivity),
                         (uint32_t)Rf_asInteger(least), (uint64_t)Rf_asReal(seed), 0, label, &planes, &count));
  SEXP rows = PROTECT(Rf_allocVector(REALSXP, (R_xlen_t)(4 * count)));
  memcpy(REAL(rows), planes, 4 * count * sizeof(double));
  ilot_free(planes);
  SEXP labels = PROTECT(Rf_allocVector(INTSXP, (R_xlen_t)points));
  for (size_t i = 0; i < points; ++i) INTEGER(labels)[i] = (int)label[i];
  SEXP made = pair_of(labels, rows);
  UNPROTECT(2);
  return made;
}

static SEXP delaunay_r(SEXP x, SEXP y) {
  uint32_t* corners = NULL;
  size_t triangles = 0;
  check(ilot_delaunay(REAL(x), REAL(y), (size_t)XLENGTH(x), &corners, &triangles));
  SEXP made = PROTECT(indices_of(corners, 3 * triangles, 0));
  ilot_free(corners);
  UNPROTECT(1);
  return made;
}

#define ENTRY(name, arguments) {#name, (DL_FUNC)&name, arguments}
static const R_CallMethodDef kEntries[] = {
    ENTRY(version_r, 0),     ENTRY(read_cloud_r, 1), ENTRY(measure_r, 1),  ENTRY(write_cloud_r, 5),
    ENTRY(run_r, 4),         ENTRY(parameters_r, 0), ENTRY(read_result_r, 2), ENTRY(neighbours_r, 5),
    ENTRY(normals_r, 5),     ENTRY(clusters_r, 4),   ENTRY(planes_r, 8),   ENTRY(delaunay_r, 2),
    {NULL, NULL, 0}};

void R_init_ilot(DllInfo* library) {
  R_registerRoutines(library, NULL, kEntries, NULL, NULL);
  R_useDynamicSymbols(library, FALSE);
}
