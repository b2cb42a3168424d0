# SPDX-License-Identifier: Apache-2.0
"""What all algorithms share."""
from qgis.core import QgsProcessingAlgorithm, QgsProcessingParameterDefinition, QgsProcessingParameterFile

CLOUDS = "Point clouds (*.las *.laz *.e57 *.ptx *.pts *.ply *.pcd *.xyz *.txt *.csv);;All files (*)"


class Algorithm(QgsProcessingAlgorithm):
    """A subclass gives NAME, TITLE and HELP."""
    NAME, TITLE, HELP = "", "", ""

    def name(self):
        return self.NAME

    def displayName(self):
        return self.TITLE

    def shortHelpString(self):
        return self.HELP

    def createInstance(self):
        return type(self)()

    def add(self, parameter, optional=False, advanced=False):
        flags = parameter.flags()
        if optional:
            flags |= QgsProcessingParameterDefinition.FlagOptional
        if advanced:
            flags |= QgsProcessingParameterDefinition.FlagAdvanced
        parameter.setFlags(flags)
        self.addParameter(parameter)


def cloud_parameter(name="INPUT", title="Point cloud"):
    return QgsProcessingParameterFile(name, title, fileFilter=CLOUDS)
