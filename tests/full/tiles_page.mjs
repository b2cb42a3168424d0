// SPDX-License-Identifier: Apache-2.0
// The script of the page of tests/full/tiles_browser.py: draws a tileset by NASA's 3d-tiles-renderer, looks at it from the
// south and above, and leaves in window.seen what was drawn, with the metadata of the first building that a ray hits.
import {Color, DirectionalLight, HemisphereLight, Matrix4, PerspectiveCamera, Raycaster, Scene, Sphere, Vector2, Vector3,
        WebGLRenderer} from 'three';
import {TilesRenderer} from '3d-tiles-renderer';
import {GLTFExtensionsPlugin, GLTFMeshFeaturesExtension, GLTFStructuralMetadataExtension, ImplicitTilingPlugin} from '3d-tiles-renderer/plugins';

const tileset = await (await fetch('/3dtiles/tileset.json')).json();
const renderer = new WebGLRenderer({antialias: true, preserveDrawingBuffer: true});
renderer.setSize(innerWidth, innerHeight);
document.body.append(renderer.domElement);
const scene = new Scene();
scene.background = new Color(0xdfe8f0);
const sun = new DirectionalLight(0xffffff, 2.2);
scene.add(sun, new HemisphereLight(0xffffff, 0x888888, 1.4));
const camera = new PerspectiveCamera(40, innerWidth / innerHeight, 1, 1e5);
const tiles = new TilesRenderer('/3dtiles/tileset.json');
tiles.registerPlugin(new ImplicitTilingPlugin());
tiles.registerPlugin(new GLTFExtensionsPlugin({
  plugins: [() => new GLTFMeshFeaturesExtension(), () => new GLTFStructuralMetadataExtension()]}));
tiles.errorTarget = 1;
tiles.setCamera(camera);
tiles.setResolutionFromRenderer(camera, renderer);
scene.add(tiles.group);
window.seen = {faults: [], tiles: 0};
tiles.addEventListener('load-error', ({error, url}) => window.seen.faults.push(`${url}: ${error}`));
tiles.addEventListener('load-model', () => ++window.seen.tiles);

function place_camera() {
  const sphere = new Sphere();
  if (!tiles.getBoundingSphere(sphere)) return false;
  const frame = new Matrix4().fromArray(tileset.root.transform ?? new Matrix4().elements);  // east, north, up
  // The whole scene is brought into the frame of the root, with z up: graphics cards have no float64.
  tiles.group.matrix.copy(frame.invert());
  tiles.group.matrix.decompose(tiles.group.position, tiles.group.quaternion, tiles.group.scale);
  tiles.group.updateMatrixWorld(true);
  const middle = sphere.center.applyMatrix4(tiles.group.matrix), far = 2.1 * sphere.radius;
  camera.up.set(0, 0, 1);
  camera.position.copy(middle).add(new Vector3(-0.35, -0.8, 0.7).multiplyScalar(far));
  camera.lookAt(middle);
  camera.far = 10 * far;
  camera.updateProjectionMatrix();
  sun.position.set(-0.6, -1, 1.3);
  return true;
}

// Metadata of the first hit among rays over the picture.
function hit_metadata() {
  const caster = new Raycaster();
  for (let y = -0.9; y <= 0.9; y += 0.02)
    for (let x = -0.95; x <= 0.95; x += 0.015) {
      caster.setFromCamera(new Vector2(x, y), camera);
      const [hit] = caster.intersectObject(tiles.group, true);
      const {meshFeatures, structuralMetadata} = hit?.object.userData ?? {};
      if (!meshFeatures || !structuralMetadata) continue;
      const ids = meshFeatures.getFeatures(hit.faceIndex, hit.barycoord ?? new Vector3(1, 0, 0));
      const tables = meshFeatures.getFeatureInfo().map(info => info.propertyTable);
      return structuralMetadata.getPropertyTableData(tables, ids);
    }
  return null;
}

let placed = false;
function frame() {
  requestAnimationFrame(frame);
  if (!placed) placed = place_camera();
  camera.updateMatrixWorld();
  tiles.update();
  renderer.render(scene, camera);
  window.seen.triangles = renderer.info.render.triangles;
  window.seen.still = placed && window.seen.tiles > 0 && tiles.loadProgress === 1;
}
window.look = () => JSON.stringify({...window.seen, metadata: hit_metadata()},
  (key, value) => typeof value === 'bigint' ? Number(value) : value);
frame();
