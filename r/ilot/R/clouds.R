# SPDX-License-Identifier: Apache-2.0
# Point clouds as data frames with lidR's column names.

ilot_version <- function() .Call(version_r)

# X, Y, Z in CRS units; Intensity, Classification, R, G, B as integers, zeros where the cloud has none.
read_cloud <- function(path) {
  columns <- .Call(read_cloud_r, one_text(path, "path"))
  names(columns) <- c("X", "Y", "Z", "Intensity", "Classification", "R", "G", "B")
  as.data.frame(columns)
}

# What the points really are: number, bounds, classes, density, sampling step, suitability for each product.
cloud_info <- function(path) jsonlite::fromJSON(.Call(measure_r, one_text(path, "path")))

# .las, .laz, .copc.laz or .ply; appears whole or not at all. Columns other than those of read_cloud() are not written.
write_cloud <- function(cloud, path, crs = "", scale = 0.001) {
  places <- lapply(c("X", "Y", "Z"), function(name) numbers(cloud[[name]], name))
  attributes <- Map(function(name, largest) whole_numbers(cloud[[name]], name, largest),
                    c("Intensity", "Classification", "R", "G", "B"), c(65535, 255, 65535, 65535, 65535))
  given <- lengths(c(places, Filter(Negate(is.null), attributes)))
  if (any(given != given[1])) stop("X, Y, Z and all attributes must have the same number of values", call. = FALSE)
  .Call(write_cloud_r, one_text(path, "path"), places, unname(attributes), one_text(crs, "crs"), as.double(scale))
  invisible(path)
}

one_text <- function(value, name) {
  if (length(value) != 1 || is.na(value)) stop(name, ": one text is expected", call. = FALSE)
  as.character(value)
}

numbers <- function(values, name) {
  if (!is.numeric(values)) stop(name, ": numbers are expected, not ", class(values)[1], call. = FALSE)
  as.double(values)
}

whole_numbers <- function(values, name, largest) {
  if (is.null(values)) return(NULL)
  if (!is.numeric(values) || anyNA(values) || any(values < 0 | values > largest))
    stop(name, ": whole numbers from 0 to ", largest, " are expected", call. = FALSE)
  as.integer(values)
}
