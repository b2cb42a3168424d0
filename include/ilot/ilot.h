/* SPDX-License-Identifier: Apache-2.0
 * ilot for C, and for every language that calls C: R, Julia, C#. Link with -lilot (pkg-config ilot); C99 or later.
 *
 *   ilot_cloud* cloud = NULL;
 *   if (ilot_cloud_open("district.laz", &cloud) != ILOT_OK) fprintf(stderr, "%s\n", ilot_last_error());
 *   ilot_cloud_close(cloud);
 *
 * - Functions that can fail return an ilot_status; after any but ILOT_OK and ILOT_INCOMPLETE, ilot_last_error() is a
 *   sentence that says what is wrong, where, and what to do. No function prints, exits or lets an exception out.
 * - Texts are UTF-8 and end with a zero. Arrays are the caller's, contiguous, of as many entries as `points` says; they
 *   are read where they are. NULL is refused except where it is said to be allowed.
 * - Outputs (handles, texts, arrays, counts) are NULL or 0 after a fault.
 * - What the library allocates (texts as JSON, arrays without a known size) is given back by ilot_free().
 * - Handles belong to one thread at a time. All other functions may be called from several threads at once.
 * - Stable: in libilot.so.1 no function changes or goes; new ones come. JSON objects may get new members.
 * The meaning of everything is that of the headers for C++ beside this one, which each group names. */
#ifndef ILOT_ILOT_H
#define ILOT_ILOT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__)
#define ILOT_PUBLIC __attribute__((visibility("default")))
#else
#define ILOT_PUBLIC
#endif

/* The exit codes of the program. An int, so that its size is that of every compiler. */
typedef int32_t ilot_status;
#define ILOT_OK 0
#define ILOT_FAILED 1        /* a file is damaged, the disk is full, memory ran out */
#define ILOT_USAGE 2         /* what was asked for cannot be: a wrong value, a missing file, NULL */
#define ILOT_INCOMPLETE 3    /* a run is done, but something was skipped; its run.json says what */
#define ILOT_INTERRUPTED 130 /* stopped on request; a run can be resumed */

#define ILOT_NO_POINT UINT32_MAX /* an index that means none */

/* ---- The library ---- */

/* 1; a later library of the same soname may give a larger number, with more functions. */
ILOT_PUBLIC int32_t ilot_abi_version(void);
/* "0.1.0". Not to be freed. */
ILOT_PUBLIC const char* ilot_version(void);
/* What the last failed call of this thread says; empty when none failed. Valid until the thread's next failed call. */
ILOT_PUBLIC const char* ilot_last_error(void);
/* Gives back what a function of the library allocated; NULL is allowed. */
ILOT_PUBLIC void ilot_free(void* allocated);

/* ---- Clouds: clouds.h ---- */

typedef struct ilot_cloud ilot_cloud;

/* Opens a cloud of any format that is read. *cloud is NULL after a fault. */
ILOT_PUBLIC ilot_status ilot_cloud_open(const char* path, ilot_cloud** cloud);
/* Closes it; NULL is allowed. */
ILOT_PUBLIC void ilot_cloud_close(ilot_cloud* cloud);
/* Rows that can be read. 0 for NULL. */
ILOT_PUBLIC uint64_t ilot_cloud_rows(const ilot_cloud* cloud);
/* Arrays of `capacity` entries to read into; those of intensity, classification and colour may be NULL. */
typedef struct ilot_columns {
  double *x, *y, *z;   /* units of the CRS */
  uint16_t* intensity; /* as in the file */
  uint8_t* classification;
  uint16_t *red, *green, *blue; /* 0 to 65535 */
} ilot_columns;
/* Reads up to `capacity` rows from row `first` on. *rows: how many rows there were, 0 at the end. *points: how many of
 * the entries are points; rows with unusable coordinates give none. */
ILOT_PUBLIC ilot_status ilot_cloud_read(ilot_cloud* cloud, uint64_t first, size_t capacity, const ilot_columns* columns,
                                        uint64_t* rows, size_t* points);
/* What the points really are, as a JSON object: valid_points, min, max, classes, density, sampling_step_m, crs, suits,
 * warnings ... Reads the cloud two or three times. */
ILOT_PUBLIC ilot_status ilot_cloud_measure(ilot_cloud* cloud, char** json);

typedef struct ilot_writer ilot_writer;

/* Begins a cloud: .las, .laz, .copc.laz or .ply. crs: "EPSG:2154", empty or NULL. Coordinates are rounded to multiples
 * of `scale` from the offset, which is near the points. colour: not 0 = red, green and blue are written. */
ILOT_PUBLIC ilot_status ilot_writer_open(const char* path, const char* crs, double scale, const double offset[3],
                                         int32_t colour, ilot_writer** writer);
/* Appends points. Of attributes NULL is all zeros. After a fault, or after ilot_writer_finish(), a writer takes no
 * more. */
ILOT_PUBLIC ilot_status ilot_writer_write(ilot_writer* writer, size_t points, const ilot_columns* columns);
/* The file appears whole under its name. */
ILOT_PUBLIC ilot_status ilot_writer_finish(ilot_writer* writer);
/* Gives the handle back; a file that was not finished does not appear. NULL is allowed. */
ILOT_PUBLIC void ilot_writer_close(ilot_writer* writer);

/* ---- Whole runs: run.h, parameters.h ---- */

typedef struct ilot_run ilot_run;

/* Called at the start and the end of stages and every second; total 0 = not known. From threads of the library, never
 * two at once. Not 0 = stop this run, and no other. */
typedef int32_t (*ilot_progress)(void* user, const char* stage, uint64_t done, uint64_t total, double seconds);
/* A line for people, with its newline. */
typedef void (*ilot_message)(void* user, const char* line);

/* A run in the making; NULL when memory ran out. */
ILOT_PUBLIC ilot_run* ilot_run_new(void);
/* Gives it back; NULL is allowed. */
ILOT_PUBLIC void ilot_run_free(ilot_run* run);
/* A cloud, a folder of clouds, or a pattern. */
ILOT_PUBLIC ilot_status ilot_run_add_input(ilot_run* run, const char* path);
/* An option by its name: output, products ("planes,roofs"), memory_bytes, threads, store, bounds ("x0,y0,x1,y1"),
 * within (a file), footprints, id_field, stations, edits (each call adds a table), train, crs, to_crs, existing
 * (refuse, resume, overwrite); and strict, dry_run, keep_store, clouds, report ("true", "false"). */
ILOT_PUBLIC ilot_status ilot_run_set_option(ilot_run* run, const char* name, const char* value);
/* One setting: "planes.epsilon=0.02". */
ILOT_PUBLIC ilot_status ilot_run_set(ilot_run* run, const char* assignment);
/* The settings that a TOML file gives. */
ILOT_PUBLIC ilot_status ilot_run_load_config(ilot_run* run, const char* path);
/* Functions that are called while the run works, each may be NULL; `user` is handed to them. */
ILOT_PUBLIC void ilot_run_set_callbacks(ilot_run* run, ilot_progress progress, ilot_message message, void* user);
/* Makes the products. ILOT_OK or ILOT_INCOMPLETE: the folder is whole. One run at a time works in a process, a second
 * thread waits. May be called again, with other options. */
ILOT_PUBLIC ilot_status ilot_run_start(ilot_run* run);
/* Ends all that runs in this process soon, from any thread or a signal handler. Holds until ilot_accept_runs(). */
ILOT_PUBLIC void ilot_request_stop(void);
ILOT_PUBLIC void ilot_accept_runs(void);
/* All settings as a JSON list of objects: key, kind, default, minimum, maximum, choices, unit, help, optional,
 * advanced. */
ILOT_PUBLIC ilot_status ilot_parameters(char** json);

/* ---- The results of a run, read back: run.h, planes.h, roofs.h, facades.h, streets.h ---- */

/* Each gives JSON with the names of the headers' fields; a place is [x, y, z] in the CRS of the clouds. */
ILOT_PUBLIC ilot_status ilot_read_run(const char* folder, char** json);
ILOT_PUBLIC ilot_status ilot_read_planes(const char* folder, char** json);
ILOT_PUBLIC ilot_status ilot_read_roofs(const char* folder, char** json);
ILOT_PUBLIC ilot_status ilot_read_facades(const char* folder, char** json);
ILOT_PUBLIC ilot_status ilot_read_streets(const char* folder, char** json);

/* ---- Points in memory: neighbours.h, clusters.h, plane_search.h, delaunay.h. threads: 0 = all ---- */

/* index and distance: points x count entries, the nearest first; ILOT_NO_POINT and infinity where there is none.
 * count: 1 to 64. max_distance: 0 = however far. */
ILOT_PUBLIC ilot_status ilot_nearest_neighbours(const double* x, const double* y, const double* z, size_t points,
                                                int32_t count, double max_distance, int32_t threads, uint32_t* index,
                                                float* distance);
/* normals: 3 x points entries, nx ny nz of each point, pointing up, zeros where there is none. curvature: points
 * entries, or NULL. count: 3 to 64. */
ILOT_PUBLIC ilot_status ilot_estimate_normals(const double* x, const double* y, const double* z, size_t points,
                                              int32_t count, double max_distance, int32_t threads, float* normals,
                                              float* curvature);
/* id: points entries, from 0 to *clusters - 1. */
ILOT_PUBLIC ilot_status ilot_euclidean_clusters(const double* x, const double* y, const double* z, size_t points,
                                                double radius, uint32_t* id, uint32_t* clusters);
/* label: points entries, 0 = none, else 1 + number of the plane. *planes: 4 x *count entries (nx, ny, nz, d), to be
 * freed. epsilon, normal_angle_deg, connectivity: not a number = chosen from the points; min_points: 0 = chosen. */
ILOT_PUBLIC ilot_status ilot_find_planes(const double* x, const double* y, const double* z, size_t points,
                                         double epsilon, double normal_angle_deg, double connectivity,
                                         uint32_t min_points, uint64_t seed, int32_t threads, uint32_t* label,
                                         double** planes, size_t* count);
/* *corners: 3 x *triangles indices of points, which turn left; to be freed. */
ILOT_PUBLIC ilot_status ilot_delaunay(const double* x, const double* y, size_t points, uint32_t** corners,
                                      size_t* triangles);
/* The triangles of circumradius `reach` at most, joined, as a JSON object: area, and polygons, a list of lists of rings
 * of indices of points, the outer ring first. */
ILOT_PUBLIC ilot_status ilot_alpha_shape(const double* x, const double* y, size_t points, double reach,
                                         int32_t fill_holes, char** json);

#ifdef __cplusplus
}
#endif

#endif
