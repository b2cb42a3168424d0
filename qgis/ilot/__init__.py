# SPDX-License-Identifier: Apache-2.0
"""ilot in the Processing toolbox of QGIS."""


def classFactory(iface):  # the name that QGIS asks for
    from .provider import Plugin
    return Plugin(iface)
