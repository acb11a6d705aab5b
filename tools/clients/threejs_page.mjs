// In the browser: what three.js sees of the pictures. +X is east, +Y up, -Z north.

import * as THREE from 'three';
import { EXRLoader } from 'three/addons/loaders/EXRLoader.js';

const LIGHT_SCALE = 1e-4;  // Surfaces are lit through half floats, which end at 65504.

const renderer = new THREE.WebGLRenderer();
const scene = new THREE.Scene();
const camera = new THREE.PerspectiveCamera(90, 1, 0.01, 100);

const toThree = ([east, north, up]) => new THREE.Vector3(east, up, -north);
const fromThree = ({ x, y, z }) => [x, -z, y];

/// RGB of every pixel, rows from below.
function render(size) {
  const target = new THREE.WebGLRenderTarget(size, size, { type: THREE.FloatType });
  const pixels = new Float32Array(4 * size * size);
  renderer.setRenderTarget(target);
  renderer.render(scene, camera);
  renderer.readRenderTargetPixels(target, 0, 0, size, size, pixels);
  target.dispose();
  return pixels;
}

function look(towards, up, fovDeg) {
  camera.up.copy(up);
  camera.fov = fovDeg;
  camera.updateProjectionMatrix();
  camera.lookAt(towards);
  camera.updateMatrixWorld();
}

const steep = (v) => Math.abs(v.y) > 0.9;
const upFor = (v) => (steep(v) ? new THREE.Vector3(0, 0, 1) : new THREE.Vector3(0, 1, 0));

function inDirection(direction) {
  const towards = toThree(direction);
  look(towards, upFor(towards), 0.02);
  return Array.from(render(1).subarray(0, 3));
}

/// Direction of the brightest pixel of six square views.
function brightest(size) {
  let best = 0;
  let where;
  for (const axis of [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]]) {
    const towards = new THREE.Vector3(...axis);
    look(towards, upFor(towards), 90);
    const pixels = render(size);
    for (let i = 0; i < size * size; ++i) {
      if (pixels[4 * i + 1] <= best) continue;
      best = pixels[4 * i + 1];
      where = new THREE.Vector3(2 * (i % size + 0.5) / size - 1, 2 * (Math.floor(i / size) + 0.5) / size - 1, -1)
        .applyQuaternion(camera.quaternion);
    }
  }
  return fromThree(where);
}

async function loadExr(file) {
  const texture = await new EXRLoader().setDataType(THREE.FloatType).loadAsync(file);
  texture.minFilter = texture.magFilter = THREE.LinearFilter;
  texture.generateMipmaps = false;
  return texture;
}

async function latlong(file) {
  const texture = await loadExr(file);
  texture.mapping = THREE.EquirectangularReflectionMapping;
  return texture;
}

/// EXRLoader has the lowest row first, faces of cubes want the uppermost.
function upsideDown(texture) {
  const { data, width, height } = texture.image;
  const row = 4 * width;
  const turned = new Float32Array(data.length);
  for (let y = 0; y < height; ++y) turned.set(data.subarray(y * row, (y + 1) * row), (height - 1 - y) * row);
  texture.image.data = turned;
  return texture;
}

async function cube(pattern) {
  const faces = [];
  for (const face of ['px', 'nx', 'py', 'ny', 'pz', 'nz']) faces.push(upsideDown(await loadExr(pattern.replace('{}', face))));
  const texture = new THREE.CubeTexture(faces);
  texture.type = THREE.FloatType;
  texture.format = THREE.RGBAFormat;
  texture.colorSpace = THREE.LinearSRGBColorSpace;
  texture.minFilter = texture.magFilter = THREE.LinearFilter;
  texture.generateMipmaps = false;
  texture.needsUpdate = true;
  return texture;
}

function seen(texture, directions) {
  scene.background = texture;
  const answer = { rgb: directions.map(inDirection), brightest: brightest(256) };
  scene.background = null;
  return answer;
}

/// Illuminance of a white plane that faces up.
function onHorizontal(material) {
  const plane = new THREE.Mesh(new THREE.PlaneGeometry(10, 10), material);
  plane.rotation.x = -Math.PI / 2;
  plane.position.y = -1;
  scene.add(plane);
  look(new THREE.Vector3(0, -1, 0), new THREE.Vector3(0, 0, 1), 1);
  const rgb = Array.from(render(1).subarray(0, 3), (value) => Math.PI * value);
  scene.remove(plane);
  return rgb;
}

async function main() {
  const request = await (await fetch('/threejs-request.json')).json();
  const answer = { revision: THREE.REVISION };
  const sky = await latlong(request.latlong);
  answer.latlong = seen(sky, request.directions);
  answer.cube = seen(await cube(request.cube), request.directions);

  const lamp = new THREE.DirectionalLight(new THREE.Color(...request.sun_rgb_lux.map((value) => value * LIGHT_SCALE)), 1);
  lamp.position.copy(toThree(request.sun));
  scene.add(lamp);
  answer.sun_on_horizontal = onHorizontal(new THREE.MeshLambertMaterial()).map((value) => value / LIGHT_SCALE);
  scene.remove(lamp);

  const dimmed = sky.image.data.map((value) => value * LIGHT_SCALE);
  scene.environment = new THREE.DataTexture(dimmed, sky.image.width, sky.image.height, THREE.RGBAFormat, THREE.FloatType,
    THREE.EquirectangularReflectionMapping, undefined, undefined, THREE.LinearFilter, THREE.LinearFilter);
  scene.environment.needsUpdate = true;
  // Only this material takes light from environments; it also reflects a little by its clear surface.
  answer.sky_on_horizontal = onHorizontal(new THREE.MeshStandardMaterial({ roughness: 1, metalness: 0 })).map((value) => value / LIGHT_SCALE);
  await fetch('/answer', { method: 'POST', body: JSON.stringify(answer) });
}

main().catch((error) => fetch('/failure', { method: 'POST', body: error.stack ?? String(error) }));
