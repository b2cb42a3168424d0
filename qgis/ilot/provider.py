# SPDX-License-Identifier: Apache-2.0
"""The group ilot of the toolbox. Its setting is the place of the program; without it PATH is searched."""
from processing.core.ProcessingConfig import ProcessingConfig, Setting
from qgis.core import QgsApplication, QgsProcessingProvider

from .product_algorithm import PRODUCTS, ProductAlgorithm
from .program import EXECUTABLE
from .tool_algorithms import Convert, Info, Report, Scan


class Provider(QgsProcessingProvider):
    def id(self):
        return "ilot"

    def name(self):
        return "ilot"

    def longName(self):
        return "ilot: laser-scanned cities"

    def load(self):
        ProcessingConfig.settingIcons["ilot"] = self.icon()
        ProcessingConfig.addSetting(Setting("ilot", EXECUTABLE, "The program ilot; empty: as PATH finds it", "",
                                            valuetype=Setting.FILE))
        ProcessingConfig.readSettings()
        self.refreshAlgorithms()
        return True

    def unload(self):
        ProcessingConfig.removeSetting(EXECUTABLE)

    def loadAlgorithms(self):
        for product in PRODUCTS:
            self.addAlgorithm(ProductAlgorithm(product))
        for kind in (Info, Convert, Scan, Report):
            self.addAlgorithm(kind())


class Plugin:
    """What QGIS loads."""

    def __init__(self, iface):
        self.provider = None

    def initProcessing(self):
        self.provider = Provider()
        QgsApplication.processingRegistry().addProvider(self.provider)

    def initGui(self):
        self.initProcessing()

    def unload(self):
        QgsApplication.processingRegistry().removeProvider(self.provider)
