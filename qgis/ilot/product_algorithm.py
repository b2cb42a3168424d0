# SPDX-License-Identifier: Apache-2.0
"""One product of point clouds. The fields of the form are the settings of its section that the program declares."""
import pathlib

from qgis.core import (QgsProcessing, QgsProcessingContext, QgsProcessingException, QgsProcessingOutputFile,
                       QgsProcessingOutputFolder, QgsProcessingOutputNumber, QgsProcessingParameterBoolean,
                       QgsProcessingParameterEnum, QgsProcessingParameterFile, QgsProcessingParameterFolderDestination,
                       QgsProcessingParameterMultipleLayers, QgsProcessingParameterNumber, QgsProcessingParameterString,
                       QgsProcessingUtils, QgsProviderRegistry)

from .algorithm import Algorithm
from .program import output_of, run
from .settings import fields_of

PRODUCTS = {
    "planes": ("Planes", "Labels every point with its plane; planes as a table and as outlines."),
    "roofs": ("Roofs", "LoD2 models of buildings (CityJSON), roof faces as layers."),
    "facades": ("Plans of facades", "Plans of facades as DXF, SVG and PDF; tables of windows and doors."),
    "streets": ("Streets", "Objects on the ground with classes, city blocks, images from above."),
}
EXISTING = ["refuse", "resume", "overwrite"]


def name_of(key):
    """Names of parameters have no dots."""
    return key.upper().replace(".", "_")


def parameter_of(field):
    """The field of the form. Settings that may be auto and lists are texts, empty for their default."""
    unit = f" ({field.unit})" if field.unit else ""
    title = field.help[:1].upper() + field.help[1:] + unit
    name = name_of(field.key)
    if field.kind == "boolean" and not field.optional:
        return QgsProcessingParameterBoolean(name, title, field.default == "true")
    if field.kind in ("boolean", "choice"):
        words = list(field.choices) or ["true", "false"]
        words += ["auto"] if field.optional else []
        return QgsProcessingParameterEnum(name, title, words, defaultValue=field.default.strip('"'), usesStaticStrings=True)
    if field.kind in ("integer", "number") and not field.default.startswith('"') and not field.optional:
        kind = QgsProcessingParameterNumber.Integer if field.kind == "integer" else QgsProcessingParameterNumber.Double
        most = min(field.maximum, 2**31 - 1) if field.kind == "integer" else field.maximum
        return QgsProcessingParameterNumber(name, title, kind, float(field.default), False, field.minimum, most)
    return QgsProcessingParameterString(name, title, field.default.strip('"'), optional=True)


class ProductAlgorithm(Algorithm):
    def __init__(self, product):
        super().__init__()
        self.product = product
        self.NAME, (self.TITLE, self.HELP) = product, PRODUCTS[product]
        self.fields = []

    def createInstance(self):
        return ProductAlgorithm(self.product)

    def declared(self):
        """The settings of the product; none where the program is missing, so that the toolbox still loads."""
        try:
            return [f for f in fields_of(output_of("run", "--print-config")) if f.key.startswith(self.product + ".")]
        except QgsProcessingException:
            return []

    def initAlgorithm(self, configuration=None):
        self.fields = self.declared()
        self.add(QgsProcessingParameterMultipleLayers("INPUT", "Point clouds", QgsProcessing.TypeFile))
        if self.product == "roofs":
            self.add(QgsProcessingParameterFile("FOOTPRINTS", "Outlines of buildings"), optional=True)
        if self.product == "facades":
            self.add(QgsProcessingParameterFile("STATIONS", "Where the scanners stood"), optional=True)
        for field in self.fields:
            self.add(parameter_of(field), optional=True, advanced=field.advanced)
        self.add(QgsProcessingParameterString("SETTINGS", "Settings of other sections, as planes.epsilon=0.02, one a line",
                                              multiLine=True), optional=True, advanced=True)
        self.add(QgsProcessingParameterString("BOUNDS", "Only in this box: X0,Y0,X1,Y1"), optional=True, advanced=True)
        self.add(QgsProcessingParameterString("CRS", "Coordinate system that overrides what the clouds say: EPSG:n"),
                 optional=True, advanced=True)
        self.add(QgsProcessingParameterString("MEMORY", "Memory", "2G"), advanced=True)
        self.add(QgsProcessingParameterEnum("EXISTING", "Where the folder exists", EXISTING, defaultValue="refuse",
                                            usesStaticStrings=True))
        self.add(QgsProcessingParameterBoolean("LOAD", "Open the layers", True))
        self.add(QgsProcessingParameterFolderDestination("OUTPUT", "Folder for the results"))
        self.addOutput(QgsProcessingOutputFile("REPORT", "Report"))
        self.addOutput(QgsProcessingOutputNumber("LAYERS", "Layers that were opened"))

    def assignments(self, parameters, context):
        """--set for each field that is not at its default."""
        out = []
        for field in self.fields:
            name = name_of(field.key)
            if parameters.get(name) is None:
                continue
            parameter = self.parameterDefinition(name)
            if parameter.type() == "boolean":
                value = str(self.parameterAsBool(parameters, name, context)).lower()
            elif parameter.type() == "enum":
                value = self.parameterAsEnumString(parameters, name, context)
            elif parameter.type() == "number" and field.kind == "integer":
                value = str(self.parameterAsInt(parameters, name, context))
            elif parameter.type() == "number":
                value = repr(self.parameterAsDouble(parameters, name, context))
            else:
                value = self.parameterAsString(parameters, name, context).strip()
            if value and value != field.default.strip('"'):
                out += ["--set", f"{field.key}={value}"]
        for line in self.parameterAsString(parameters, "SETTINGS", context).splitlines():
            out += ["--set", line.strip()] if line.strip() else []
        return out

    def processAlgorithm(self, parameters, context, feedback):
        folder = self.parameterAsString(parameters, "OUTPUT", context)
        existing = self.parameterAsEnumString(parameters, "EXISTING", context)
        if existing == "refuse" and pathlib.Path(folder).is_dir() and not any(pathlib.Path(folder).iterdir()):
            existing = "overwrite"  # QGIS makes folders that it names itself
        arguments = ["run", *self.parameterAsFileList(parameters, "INPUT", context), "-o", folder, "--products", self.product]
        arguments += self.assignments(parameters, context)
        arguments += [] if existing == "refuse" else ["--" + existing]
        for name, option in (("FOOTPRINTS", "--footprints"), ("STATIONS", "--stations"), ("BOUNDS", "--bounds"),
                             ("CRS", "--crs"), ("MEMORY", "--memory")):
            value = self.parameterAsString(parameters, name, context) if self.parameterDefinition(name) else ""
            arguments += [option, value] if value else []
        run(arguments, feedback, events=True)
        count = 0
        if self.parameterAsBool(parameters, "LOAD", context):
            count = open_layers(pathlib.Path(folder), context, feedback)
        return {"OUTPUT": folder, "REPORT": str(pathlib.Path(folder) / "report.html"), "LAYERS": count}


def open_layers(folder, context, feedback):
    """Has every layer of the result's GeoPackages and its images opened after the run. The style of a layer of a GeoPackage
    is the default one of the table layer_styles beside it. Returns how many layers there are."""
    metadata = QgsProviderRegistry.instance().providerMetadata("ogr")
    found = {}
    for path in sorted(folder.rglob("*.gpkg")):
        for sub in metadata.querySublayers(str(path)):
            if sub.name() != "layer_styles":
                found[sub.uri()] = sub.name()
    for path in sorted(folder.rglob("*.tif")):
        found[str(path)] = path.stem
    count = 0
    for uri, name in found.items():
        layer = QgsProcessingUtils.mapLayerFromString(uri, context)
        if layer is None or not layer.isValid():
            feedback.reportError(f"{uri}: cannot be opened")
            continue
        context.addLayerToLoadOnCompletion(layer.id(), QgsProcessingContext.LayerDetails(name, context.project(), name))
        layer.loadDefaultStyle()
        feedback.pushInfo(f"layer {name}: {layer.renderer().type()}")
        count += 1
    return count
