# SPDX-License-Identifier: Apache-2.0
"""info, convert, scan and report."""
import re

from qgis.core import (QgsProcessingException, QgsProcessingOutputFile, QgsProcessingParameterEnum, QgsProcessingParameterFile,
                       QgsProcessingParameterFileDestination, QgsProcessingParameterNumber, QgsProcessingParameterString)

from .algorithm import CLOUDS, Algorithm, cloud_parameter
from .program import output_of, run


class Info(Algorithm):
    NAME, TITLE = "info", "What a cloud contains"
    HELP = "Bounds, classes, density, sampling step as measured, and which products the cloud suits, as JSON."

    def initAlgorithm(self, configuration=None):
        self.add(cloud_parameter())
        self.add(QgsProcessingParameterFileDestination("OUTPUT", "Description", "JSON (*.json)"))

    def processAlgorithm(self, parameters, context, feedback):
        cloud = self.parameterAsFile(parameters, "INPUT", context)
        output = self.parameterAsFileOutput(parameters, "OUTPUT", context)
        text = output_of("info", cloud, "--json")
        with open(output, "w", encoding="utf-8") as file:
            file.write(text)
        feedback.pushInfo(text)
        return {"OUTPUT": output}


class Convert(Algorithm):
    NAME, TITLE = "convert", "Another format"
    HELP = "Copies a point cloud into the format that the extension of the output names; attributes are kept."

    def initAlgorithm(self, configuration=None):
        self.add(cloud_parameter())
        self.add(QgsProcessingParameterFileDestination("OUTPUT", "Output", "LAZ (*.laz);;LAS (*.las);;PLY (*.ply);;Text (*.csv)"))

    def processAlgorithm(self, parameters, context, feedback):
        output = self.parameterAsFileOutput(parameters, "OUTPUT", context)
        run(["convert", self.parameterAsFile(parameters, "INPUT", context), output, "--overwrite"], feedback)
        return {"OUTPUT": output}


def scenes():
    """The names of the scenes that the scanner knows; none where the program is missing."""
    try:
        return re.findall(r"^(\w[\w-]*) ", output_of("scan", "--list"), re.M)
    except QgsProcessingException:
        return []


class Scan(Algorithm):
    NAME, TITLE = "scan", "Virtual scan"
    HELP = "Scans a scene that does not exist, or a model (CityJSON or OBJ); exact truth is written beside the cloud."

    def initAlgorithm(self, configuration=None):
        names = scenes()
        self.add(QgsProcessingParameterEnum("SCENE", "Scene", names, defaultValue=names[0] if names else None,
                                            usesStaticStrings=True), optional=True)
        self.add(QgsProcessingParameterFile("MODEL", "Model in place of a scene", fileFilter="Models (*.json *.obj)"),
                 optional=True)
        self.add(QgsProcessingParameterNumber("POINTS", "Points; 0: as the scene has them", defaultValue=0, minValue=0))
        self.add(QgsProcessingParameterNumber("SEED", "Seed", defaultValue=0, minValue=0))
        self.add(QgsProcessingParameterString("SETTINGS", "Settings of the scene, as scene.noise=0.01, one a line",
                                              multiLine=True), optional=True, advanced=True)
        self.add(QgsProcessingParameterFileDestination("OUTPUT", "Point cloud", CLOUDS.split(";;")[0], "scan.laz"))
        self.addOutput(QgsProcessingOutputFile("TRUTH", "Truth"))

    def processAlgorithm(self, parameters, context, feedback):
        output = self.parameterAsFileOutput(parameters, "OUTPUT", context)
        model = self.parameterAsFile(parameters, "MODEL", context)
        what = ["--model", model] if model else [self.parameterAsEnumString(parameters, "SCENE", context)]
        points = self.parameterAsInt(parameters, "POINTS", context)
        what += ["--points", points] if points else []
        for line in self.parameterAsString(parameters, "SETTINGS", context).splitlines():
            what += ["--set", line.strip()] if line.strip() else []
        run(["scan", *what, "--seed", self.parameterAsInt(parameters, "SEED", context), "-o", output, "--overwrite"], feedback)
        return {"OUTPUT": output, "TRUTH": re.sub(r"(\.copc)?\.\w+$", ".truth.json", output)}


class Report(Algorithm):
    NAME, TITLE = "report", "Report of a result"
    HELP = "Makes the page of a result again, also beside another result."

    def initAlgorithm(self, configuration=None):
        folder = QgsProcessingParameterFile.Folder
        self.add(QgsProcessingParameterFile("INPUT", "Folder of the result", folder))
        self.add(QgsProcessingParameterFile("AGAINST", "Folder of another result", folder), optional=True)
        self.addOutput(QgsProcessingOutputFile("REPORT", "Report"))

    def processAlgorithm(self, parameters, context, feedback):
        result = self.parameterAsString(parameters, "INPUT", context)
        against = self.parameterAsString(parameters, "AGAINST", context)
        run(["report", result, *(["--against", against] if against else [])], feedback)
        return {"REPORT": f"{result}/report.html"}
