# SPDX-License-Identifier: Apache-2.0
# The results of a run, read back: data frames, with list columns where a value has a shape of its own. Meanings and units of
# all fields: docs/outputs.md.

read_result <- function(what, folder, ...) jsonlite::fromJSON(.Call(read_result_r, what, one_text(folder, "folder")), ...)

# What run.json says of the run: a list.
read_run <- function(folder) read_result("run", folder)

# A row a plane; normal, centroid and outline are lists.
read_planes <- function(folder) read_result("planes", folder, simplifyMatrix = FALSE)

# A row a building with its attributes; `levels` has the solids: a list of lists of lod, vertices (a matrix) and surfaces.
read_roofs <- function(folder) {
  buildings <- read_result("roofs", folder, simplifyVector = FALSE)
  rows <- frame_of(lapply(buildings, function(b) c(list(id = b$id), b$attributes)))
  rows$levels <- lapply(buildings, function(b) lapply(b$levels, level_of))
  rows
}

# A row an element of a facade; `facade` is the id of its wall.
read_facades <- function(folder) {
  walls <- read_result("facades", folder, simplifyVector = FALSE)
  simple <- c("id", "kind", "opening", "family", "row", "column", "status", "reason", "width_m", "height_m", "depth_m",
              "width_error_m", "height_error_m", "points")
  elements <- unlist(lapply(walls, function(w) lapply(w$elements, function(e) c(list(facade = w$id), e))), recursive = FALSE)
  rows <- frame_of(lapply(elements, function(e) e[c("facade", simple)]))
  rows$ring <- lapply(elements, function(e) matrix_of(e$ring))
  rows
}

# list(objects, blocks, gaps, trees, kerbs, widths, pavements, carriageways): data frames.
read_streets <- function(folder) read_result("streets", folder, simplifyMatrix = FALSE)

level_of <- function(level) {
  list(lod = level$lod, vertices = matrix_of(level$vertices),
       surfaces = lapply(level$surfaces, function(s) list(kind = s$kind, rings = lapply(s$rings, function(r) unlist(r) + 1L))))
}

matrix_of <- function(places) do.call(rbind, lapply(places, function(p) as.double(unlist(p))))

# Lists with names as a data frame; what one of them lacks is NA.
frame_of <- function(lists) {
  names <- unique(unlist(lapply(lists, names)))
  columns <- lapply(names, function(name)
    unlist(lapply(lists, function(one) if (is.null(one[[name]])) NA else one[[name]])))
  names(columns) <- names
  as.data.frame(columns, check.names = FALSE)
}
