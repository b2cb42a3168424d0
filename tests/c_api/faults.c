/* SPDX-License-Identifier: Apache-2.0
 * Every function of the C interface with what it refuses: a status and a sentence, and no crash. Exit 0: all is right.
 */
#include <ilot/ilot.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static int faults = 0;

static void expect(int good, const char* what, int line) {
  if (good) return;
  fprintf(stderr, "faults.c:%d: %s; last error: %s\n", line, what, ilot_last_error());
  ++faults;
}
#define EXPECT(good) expect((good), #good, __LINE__)
#define REFUSED(call, words) EXPECT((call) == ILOT_USAGE && strstr(ilot_last_error(), words) != NULL)

static void refuse_null(void) {
  double one = 0;
  float single = 0;
  uint32_t id = 0, *corners = NULL;
  size_t count = 0;
  uint64_t rows = 0;
  char* json = NULL;
  ilot_cloud* cloud = (ilot_cloud*)&one;
  ilot_columns columns;
  memset(&columns, 0, sizeof columns);
  REFUSED(ilot_cloud_open(NULL, &cloud), "path");
  EXPECT(cloud == NULL);
  REFUSED(ilot_cloud_open("a.laz", NULL), "cloud");
  REFUSED(ilot_cloud_read(NULL, 0, 1, &columns, &rows, &count), "cloud");
  REFUSED(ilot_cloud_measure(NULL, &json), "cloud");
  REFUSED(ilot_writer_open("a.laz", NULL, 0.001, NULL, 0, NULL), "writer");
  REFUSED(ilot_writer_write(NULL, 1, &columns), "writer");
  REFUSED(ilot_writer_finish(NULL), "writer");
  REFUSED(ilot_run_add_input(NULL, "a"), "run");
  REFUSED(ilot_run_set_option(NULL, "a", "b"), "run");
  REFUSED(ilot_run_set(NULL, "a"), "run");
  REFUSED(ilot_run_load_config(NULL, "a"), "run");
  REFUSED(ilot_run_start(NULL), "run");
  REFUSED(ilot_parameters(NULL), "json");
  REFUSED(ilot_read_run(NULL, &json), "folder");
  REFUSED(ilot_read_planes("a", NULL), "json");
  REFUSED(ilot_read_roofs(NULL, &json), "folder");
  REFUSED(ilot_read_facades(NULL, &json), "folder");
  REFUSED(ilot_read_streets(NULL, &json), "folder");
  REFUSED(ilot_nearest_neighbours(&one, &one, NULL, 1, 1, 0, 0, &id, &single), "z");
  REFUSED(ilot_estimate_normals(&one, &one, &one, 1, 3, 0, 0, NULL, NULL), "normals");
  REFUSED(ilot_euclidean_clusters(&one, &one, &one, 1, 1, NULL, &id), "id");
  REFUSED(ilot_find_planes(&one, &one, &one, 1, 1, 1, 1, 3, 0, 0, NULL, NULL, &count), "label");
  REFUSED(ilot_delaunay(NULL, &one, 1, &corners, &count), "x");
  REFUSED(ilot_alpha_shape(&one, NULL, 1, 1, 0, &json), "y");
  ilot_cloud_close(NULL);
  ilot_writer_close(NULL);
  ilot_run_free(NULL);
  ilot_run_set_callbacks(NULL, NULL, NULL, NULL);
  ilot_free(NULL);
  EXPECT(ilot_cloud_rows(NULL) == 0);
}

static void refuse_values(void) {
  double x[] = {0, 1, NAN}, y[] = {0, 1, 2};
  float single[9];
  uint32_t index[9];
  char* json = NULL;
  ilot_cloud* cloud = NULL;
  EXPECT(ilot_cloud_open("/nowhere/a.laz", &cloud) == ILOT_FAILED && strstr(ilot_last_error(), "/nowhere/a.laz"));
  REFUSED(ilot_estimate_normals(x, y, y, 3, 3, 0, 0, single, NULL), "not finite");
  REFUSED(ilot_nearest_neighbours(y, y, y, 3, 65, 0, 0, index, single), "1 to 64");
  REFUSED(ilot_nearest_neighbours(y, y, y, 3, 3, 0, -1, index, single), "threads");
  REFUSED(ilot_euclidean_clusters(y, y, y, 0, 1, index, index), "none");
  REFUSED(ilot_alpha_shape(y, y, 3, -1, 0, &json), "reach");
  REFUSED(ilot_read_planes("/nowhere", &json), "planes");
  EXPECT(json == NULL);
  ilot_run* run = ilot_run_new();
  REFUSED(ilot_run_set_option(run, "memory", "2"), "memory_bytes");
  REFUSED(ilot_run_set_option(run, "threads", "many"), "whole number");
  REFUSED(ilot_run_set_option(run, "strict", "yes"), "true or false");
  REFUSED(ilot_run_set_option(run, "bounds", "1,2,3"), "1,2,3");
  REFUSED(ilot_run_set(run, "planes.epsilom=1"), "planes.epsilon");
  REFUSED(ilot_run_start(run), "no inputs");
  ilot_run_free(run);
}

/* Whatever an output held before, it is NULL or 0 after a fault. */
static void clear_outputs(void) {
  double x[] = {0, 1, NAN}, rubbish = 0;
  uint32_t id[3], count = 7, *corners = (uint32_t*)&rubbish;
  size_t many = 7;
  uint64_t rows = 7;
  char* json = (char*)&rubbish;
  double* planes = &rubbish;
  ilot_columns columns;
  ilot_cloud* cloud = (ilot_cloud*)&rubbish;
  ilot_writer* writer = (ilot_writer*)&rubbish;
  const double offset[] = {0, 0, 0};
  memset(&columns, 0, sizeof columns);
  REFUSED(ilot_cloud_open(NULL, &cloud), "path");
  EXPECT(cloud == NULL);
  REFUSED(ilot_cloud_read(NULL, 0, 3, &columns, &rows, &many), "cloud");
  EXPECT(rows == 0 && many == 0);
  REFUSED(ilot_cloud_measure(NULL, &json), "cloud");
  EXPECT(json == NULL);
  REFUSED(ilot_writer_open("a.gif", NULL, 0.001, offset, 0, &writer), "a.gif");
  EXPECT(writer == NULL);
  REFUSED(ilot_euclidean_clusters(x, x, x, 3, 1, id, &count), "not finite");
  EXPECT(count == 0);
  many = 7;
  REFUSED(ilot_find_planes(x, x, x, 3, 1, 1, 1, 3, 0, 0, id, &planes, &many), "not finite");
  EXPECT(planes == NULL && many == 0);
  many = 7;
  REFUSED(ilot_delaunay(x, x, 3, &corners, &many), "not finite");
  EXPECT(corners == NULL && many == 0);
  many = 7;
  REFUSED(ilot_delaunay(x, x, 3, NULL, &many), "corners");
  EXPECT(many == 0);
  json = (char*)&rubbish;
  REFUSED(ilot_alpha_shape(x, x, 3, 1, 0, &json), "not finite");
  EXPECT(json == NULL);
  json = (char*)&rubbish;
  EXPECT(ilot_read_run("/nowhere", &json) != ILOT_OK && json == NULL);
}

static void write_and_read(const char* path) {
  double x[] = {1, 2, 3}, y[] = {4, 5, 6}, z[] = {7, 8, 9}, offset[] = {0, 0, 0};
  uint8_t classes[] = {2, 6, 2};
  ilot_columns columns = {0};
  columns.x = x;
  columns.y = y;
  columns.z = z;
  columns.classification = classes;
  ilot_writer* writer = NULL;
  EXPECT(ilot_writer_open(path, "EPSG:2154", 0.001, offset, 0, &writer) == ILOT_OK);
  EXPECT(ilot_writer_write(writer, 3, &columns) == ILOT_OK);
  EXPECT(ilot_writer_finish(writer) == ILOT_OK);
  REFUSED(ilot_writer_write(writer, 3, &columns), "finished");
  REFUSED(ilot_writer_finish(writer), "finished");
  ilot_writer_close(writer);
  memset(x, 0, sizeof x);
  memset(classes, 0, sizeof classes);
  ilot_cloud* cloud = NULL;
  uint64_t rows = 0;
  size_t points = 0;
  EXPECT(ilot_cloud_open(path, &cloud) == ILOT_OK && ilot_cloud_rows(cloud) == 3);
  EXPECT(ilot_cloud_read(cloud, 1, 3, &columns, &rows, &points) == ILOT_OK);
  EXPECT(rows == 2 && points == 2 && x[0] == 2 && x[1] == 3 && x[2] == 0 && classes[0] == 6);
  EXPECT(ilot_cloud_read(cloud, 3, 3, &columns, &rows, &points) == ILOT_OK && rows == 0);
  char* json = NULL;
  EXPECT(ilot_cloud_measure(cloud, &json) == ILOT_OK && strstr(json, "\"crs\":\"EPSG:2154\""));
  ilot_free(json);
  ilot_cloud_close(cloud);
}

static void few_points(void) {
  const double x[] = {0, 1, 0, 1}, y[] = {0, 0, 1, 1};
  uint32_t* corners = NULL;
  size_t triangles = 0;
  char* json = NULL;
  EXPECT(ilot_delaunay(x, y, 4, &corners, &triangles) == ILOT_OK && triangles == 2);
  ilot_free(corners);
  EXPECT(ilot_alpha_shape(x, y, 4, 1, 0, &json) == ILOT_OK && strstr(json, "\"area\":1.0"));
  ilot_free(json);
}

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  EXPECT(ilot_abi_version() == 1);
  EXPECT(ilot_last_error()[0] == 0);
  refuse_null();
  refuse_values();
  clear_outputs();
  write_and_read(argv[1]);
  few_points();
  return faults == 0 ? 0 : 1;
}
