// SPDX-License-Identifier: Apache-2.0
// All public headers in one file: none hides another, none needs another first.
#include <ilot/array_cloud.h>
#include <ilot/cloud_info.h>
#include <ilot/clouds.h>
#include <ilot/clusters.h>
#include <ilot/delaunay.h>
#include <ilot/error.h>
#include <ilot/facades.h>
#include <ilot/geometry.h>
#include <ilot/ilot.h>
#include <ilot/neighbours.h>
#include <ilot/parameters.h>
#include <ilot/plane_search.h>
#include <ilot/planes.h>
#include <ilot/rasters.h>
#include <ilot/roofs.h>
#include <ilot/run.h>
#include <ilot/settings.h>
#include <ilot/streets.h>
#include <ilot/version.h>

#include <cstdio>

int main() {
  std::printf("ilot %s\n", ilot::version().c_str());
  return ilot::version().empty() ? 1 : 0;
}
