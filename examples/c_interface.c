/* SPDX-License-Identifier: Apache-2.0
 * The C interface: reads a cloud, finds planes in it, and makes the product planes of the whole file.
 *   cc -std=c99 c_interface.c $(pkg-config --cflags --libs ilot) -o c_interface && ./c_interface CLOUD OUT */
#include <ilot/ilot.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int fail(void) {
  fprintf(stderr, "%s\n", ilot_last_error());
  return 1;
}

static int32_t show_stage(void* user, const char* stage, uint64_t done, uint64_t total, double seconds) {
  char* last = user;
  (void)done;
  (void)total;
  if (strcmp(last, stage) != 0) printf("%s after %.1f s\n", stage, seconds);
  snprintf(last, 64, "%s", stage);
  return 0; /* anything else would stop the run */
}

/* Planes among the points in memory. */
static int planes_in_memory(const char* path) {
  ilot_cloud* cloud = NULL;
  if (ilot_cloud_open(path, &cloud) != ILOT_OK) return fail();
  const size_t capacity = (size_t)ilot_cloud_rows(cloud);
  double* places = malloc((3 * capacity + 1) * sizeof(double));
  uint32_t* label = malloc((capacity + 1) * sizeof(uint32_t));
  ilot_columns columns = {0};
  columns.x = places;
  columns.y = places + capacity;
  columns.z = places + 2 * capacity;
  uint64_t rows = 0;
  size_t points = 0, count = 0;
  double* planes = NULL;
  ilot_status status = ilot_cloud_read(cloud, 0, capacity, &columns, &rows, &points);
  if (status == ILOT_OK)
    status = ilot_find_planes(columns.x, columns.y, columns.z, points, NAN, NAN, NAN, 0, 0, 0, label, &planes, &count);
  if (status == ILOT_OK)
    for (size_t i = 0; i < count && i < 3; ++i)
      printf("plane %zu: %.3f %.3f %.3f %.3f\n", i + 1, planes[4 * i], planes[4 * i + 1], planes[4 * i + 2],
             planes[4 * i + 3]);
  ilot_free(planes);
  free(label);
  free(places);
  ilot_cloud_close(cloud);
  return status == ILOT_OK ? 0 : fail();
}

/* The whole file, which need not fit into memory. */
static int whole_run(const char* path, const char* folder) {
  char stage[64] = "";
  ilot_run* run = ilot_run_new();
  ilot_run_set_callbacks(run, show_stage, NULL, stage);
  ilot_status status = ilot_run_add_input(run, path);
  if (status == ILOT_OK) status = ilot_run_set_option(run, "output", folder);
  if (status == ILOT_OK) status = ilot_run_set_option(run, "existing", "overwrite");
  if (status == ILOT_OK) status = ilot_run_set(run, "planes.epsilon=0.05");
  if (status == ILOT_OK) status = ilot_run_start(run);
  ilot_run_free(run);
  if (status != ILOT_OK && status != ILOT_INCOMPLETE) return fail();
  char* json = NULL;
  if (ilot_read_planes(folder, &json) != ILOT_OK) return fail();
  printf("%zu bytes of JSON\n", strlen(json));
  ilot_free(json);
  return 0;
}

int main(int argc, char** argv) {
  if (argc != 3) {
    fprintf(stderr, "c_interface CLOUD OUT\n");
    return 2;
  }
  printf("ilot %s\n", ilot_version());
  return planes_in_memory(argv[1]) || whole_run(argv[1], argv[2]);
}
