// SPDX-License-Identifier: Apache-2.0
import * as THREE from 'three';
window.ilot && (window.ilot.three = THREE.REVISION);
