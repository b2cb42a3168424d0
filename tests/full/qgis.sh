#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# The toolbox of QGIS, which has to be there (apt-get install qgis python3-qgis).
if ! command -v qgis_process >/dev/null; then
  echo "SKIPPED: no qgis_process (apt-get install qgis python3-qgis)"
  exit 77
fi
ILOT_NEED_QGIS=1 exec /usr/bin/python3 tests/qgis/qgis_test.py
