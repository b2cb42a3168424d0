# SPDX-License-Identifier: Apache-2.0
# Run by package_test.py: the folder has town.laz and front.laz, the environment the package and the program.
library(ilot)
folder <- commandArgs(trailingOnly = TRUE)[1]
exe <- Sys.getenv("ILOT_EXE")
at <- function(name) file.path(folder, name)

# The call fails and its sentence has the words.
refused <- function(call, words) {
  sentence <- tryCatch({ force(call); "no fault" }, error = conditionMessage)
  if (!grepl(words, sentence, fixed = TRUE)) stop("expected '", words, "', got '", sentence, "'")
}

stopifnot(nzchar(ilot_version()))

# Clouds go out and come in.
town <- read_cloud(at("town.laz"))
stopifnot(nrow(town) > 50000, identical(names(town)[1:5], c("X", "Y", "Z", "Intensity", "Classification")))
write_cloud(town, at("copy.laz"), crs = "EPSG:2154")
copy <- read_cloud(at("copy.laz"))
stopifnot(max(abs(copy$X - town$X)) < 0.00051, all(copy$Classification == town$Classification), all(copy$Intensity == town$Intensity))
info <- cloud_info(at("copy.laz"))
stopifnot(info$valid_points == nrow(town), info$crs == "EPSG:2154")
refused(read_cloud("/nowhere/a.laz"), "/nowhere/a.laz")
refused(write_cloud(transform(town, Classification = 300), at("w.laz")), "0 to 255")
refused(write_cloud(transform(town, X = NaN), at("w.laz")), "not finite")
stopifnot(!file.exists(at("w.laz")))

# Runs are those of the program.
result <- roofs(at("town.laz"), at("r"), detail = 0.1, report = FALSE, threads = 1)
stopifnot(system2(exe, c("run", at("town.laz"), "-o", at("p"), "--products", "roofs", "--set", "roofs.detail=0.1", "--no-report", "-q")) == 0)
stopifnot(result$result_hash == read_run(at("p"))$result_hash, result$exit == 0)
buildings <- read_roofs(at("r"))
solid <- buildings$status == "lod22"
stopifnot(sum(solid) > 3, all(buildings$h_roof_max[solid] > buildings$h_ground[solid]))
level <- buildings$levels[[which(solid)[1]]]
level <- level[[length(level)]]
stopifnot(level$lod == "2.2", ncol(level$vertices) == 3,
          max(unlist(lapply(level$surfaces, `[[`, "rings"))) <= nrow(level$vertices))
refused(roofs(at("town.laz"), at("r")), "exists already")
refused(run(at("town.laz"), at("x"), settings = list(planes.epsilom = 1)), "planes.epsilon")
refused(run(at("town.laz"), at("x"), treads = 2), "there is no option treads")
invisible(run(at("town.laz"), at("planes"), clouds = FALSE, report = FALSE))
planes_found <- read_planes(at("planes"))
stopifnot(identical(planes_found$id, seq_len(nrow(planes_found))), "planes.epsilon" %in% parameters()$key)
invisible(run(at("front.laz"), at("front"), products = c("facades", "streets"), clouds = FALSE, report = FALSE))
elements <- read_facades(at("front"))
stopifnot(sum(elements$kind == "window") > 5, ncol(elements$ring[[1]]) == 3)
stopifnot(setequal(names(read_streets(at("front"))), c("objects", "blocks", "gaps", "trees", "kerbs", "widths", "pavements", "carriageways")))

# Functions over points.
x <- town$X; y <- town$Y; z <- town$Z
near <- nearest_neighbours(x, y, z, 4)
distance <- sqrt((x - x[near$index[, 4]])^2 + (y - y[near$index[, 4]])^2 + (z - z[near$index[, 4]])^2)
stopifnot(all(near$index[, 1] == seq_along(x) | near$distance[, 1] == 0), max(abs(distance - near$distance[, 4])) < 0.003)
normals <- estimate_normals(x, y, z)
size <- sqrt(normals$nx^2 + normals$ny^2 + normals$nz^2)
stopifnot(all(abs(size - 1) < 1e-3 | size == 0), all(normals$nz >= 0))
found <- find_planes(x, y, z, epsilon = 0.1)
on <- found$label > 0
n <- found$planes[found$label[on], ]
stopifnot(max(abs(n[, 1] * x[on] + n[, 2] * y[on] + n[, 3] * z[on] + n[, 4])) <= 0.1 + 1e-6)
clusters <- euclidean_clusters(x, y, z, 1)
stopifnot(min(clusters) == 1, length(unique(clusters)) == max(clusters), clusters[1] == 1)
triangles <- delaunay(x, y)
turn <- (x[triangles[, 2]] - x[triangles[, 1]]) * (y[triangles[, 3]] - y[triangles[, 1]]) -
  (y[triangles[, 2]] - y[triangles[, 1]]) * (x[triangles[, 3]] - x[triangles[, 1]])
stopifnot(all(turn > 0))
refused(estimate_normals(x, y[-1], z), "different lengths")
refused(estimate_normals(c(NaN, x[-1]), y, z), "not finite")
refused(delaunay("a", "b"), "numbers")

# Ctrl-C ends a loop over runs wherever it comes: in a run, which can be resumed, at the end of a run, or between two. It comes at
# moments a seventh of a run apart, until one of them was within a run.
planes_again <- function(existing) run(at("town.laz"), at("stopped"), existing = existing, report = FALSE)
seconds <- system.time(planes_again("overwrite"))[["elapsed"]]
interrupted_at <- function(moment) {
  system(sprintf("(sleep %.3f; kill -INT %d) &", moment, Sys.getpid()))
  again <- function() {
    for (i in 1:200) planes_again("overwrite")
    "nothing was interrupted"
  }
  tryCatch(again(), error = conditionMessage, interrupt = function(i) "interrupted between runs")
}
for (moment in 0.3 + seconds * (0:49) / 7) {
  sentence <- interrupted_at(moment)
  if (!grepl("interrupted", sentence) || sentence == "nothing was interrupted") stop("Ctrl-C ended with: ", sentence)
  if (grepl("resume", sentence)) break
}
stopifnot(grepl("resume", sentence))
invisible(planes_again("resume"))
stopifnot(read_run(at("stopped"))$exit == 0)
cat("all checks of the package for R passed\n")
