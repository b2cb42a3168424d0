# SPDX-License-Identifier: Apache-2.0
# Whole runs: the same as the command `ilot run`, with the same bytes.

# inputs: clouds, folders of them, patterns. settings: list("roofs.detail" = 0.1); NULL is auto. Further arguments are options
# of the C interface by name: memory_bytes, threads, footprints, stations, edits, crs, bounds, existing = "resume" ...
# Returns what read_run() returns. Ctrl-C ends the run; existing = "resume" goes on with it.
run <- function(inputs, output, products = "planes", settings = list(), verbose = FALSE, ...) {
  options <- c(list(output = output, products = paste(products, collapse = ",")), list(...))
  texts <- vapply(options, option_text, "")
  assignments <- if (length(settings) == 0) character() else
    paste0(names(settings), "=", vapply(settings, setting_text, ""))
  .Call(run_r, as.character(inputs), texts, assignments, isTRUE(verbose))
  read_run(output)
}

planes <- function(inputs, output, ...) run_product("planes", inputs, output, ...)
roofs <- function(inputs, output, ...) run_product("roofs", inputs, output, ...)
facades <- function(inputs, output, ...) run_product("facades", inputs, output, ...)
streets <- function(inputs, output, ...) run_product("streets", inputs, output, ...)

# Settings of the product may be given by their own names: roofs(..., detail = 0.1).
run_product <- function(product, inputs, output, settings = list(), ...) {
  given <- list(...)
  own <- vapply(names(given), function(name) paste0(product, ".", name) %in% parameters()$key, TRUE)
  named <- given[own]
  names(named) <- sprintf("%s.%s", product, names(named))
  do.call(run, c(list(inputs = inputs, output = output, products = product, settings = c(settings, named)), given[!own]))
}

# All settings: a data frame of key, kind, default, unit, help ...
parameters <- function() {
  all <- jsonlite::fromJSON(.Call(parameters_r), simplifyDataFrame = FALSE)
  column <- function(name) vapply(all, function(one) as.character(one[[name]]), "")
  data.frame(key = column("key"), kind = column("kind"), default = column("default"), unit = column("unit"), help = column("help"))
}

option_text <- function(value) {
  if (is.logical(value)) return(if (isTRUE(value)) "true" else "false")
  if (is.numeric(value)) return(paste(format(value, digits = 15, scientific = FALSE, trim = TRUE), collapse = ","))
  paste(value, collapse = ",")
}

# The value as TOML has it.
setting_text <- function(value) {
  if (is.null(value)) return("auto")
  if (length(value) != 1) return(paste0("[", paste(vapply(value, setting_text, ""), collapse = ", "), "]"))
  option_text(value)
}
