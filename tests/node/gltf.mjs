// A GLB of ours, looked at by Khronos' validator and by three.js.
import assert from 'node:assert/strict';
import {createRequire} from 'node:module';

const validator = createRequire(import.meta.url)('gltf-validator');
const THREE = await import('three');
const {GLTFLoader} = await import('three/examples/jsm/loaders/GLTFLoader.js');
globalThis.self = globalThis;

/// Fails where Khronos' validator finds an error or gives a warning.
export async function validate(name, glb) {
  const {issues} = await validator.validateBytes(new Uint8Array(glb));
  const faults = issues.messages.filter(({severity}) => severity < 2);
  assert.deepEqual(faults, [], `${name}: the validator`);
}

/// What three.js makes of a GLB.
export async function load(glb) {
  const bytes = glb.buffer.slice(glb.byteOffset, glb.byteOffset + glb.length);
  const gltf = await new GLTFLoader().parseAsync(bytes, '');
  const meshes = [];
  gltf.scene.traverse((object) => { if (object.isMesh) meshes.push(object); });
  return {gltf, meshes};
}

/// Fails where the joints are not those of the rig: by name, parent and place.
export function checkJoints({gltf, meshes}, tree, metresPerUnit) {
  gltf.scene.updateMatrixWorld(true);
  const names = new Map(tree.joints.map((joint) => [joint.id, joint.name]));
  const plain = (words) => THREE.PropertyBinding.sanitizeNodeName(words);
  const bones = meshes[0].skeleton.bones;
  assert.equal(bones.length, tree.joints.length);
  tree.joints.forEach((joint, i) => {
    assert.equal(bones[i].name, plain(joint.name));
    const parent = joint.parent ? plain(names.get(joint.parent)) : 'Skeleton';
    assert.equal(bones[i].parent.name, parent);
    const place = new THREE.Vector3().setFromMatrixPosition(bones[i].matrixWorld);
    joint.position.forEach((x, k) => {
      assert.ok(Math.abs(place.getComponent(k) - x * metresPerUnit) < 1e-4, joint.name);
    });
  });
}

/// The largest distance of a vertex as three skins it to where ours is, of the size. ours: vertices,
/// and for each mesh its triangles' corners among them.
export function worstVertex({gltf, meshes}, clip, ours, metresPerUnit) {
  const mixer = new THREE.AnimationMixer(gltf.scene);
  mixer.clipAction(gltf.animations.find(({name}) => name === clip)).play();
  mixer.update(0);
  gltf.scene.updateMatrixWorld(true);
  const place = new THREE.Vector3();
  const box = new THREE.Box3();
  for (const v of ours.vertices) box.expandByPoint(place.fromArray(v));
  const size = box.getSize(new THREE.Vector3()).length();
  let worst = 0;
  assert.equal(meshes.length, ours.groups.length);
  meshes.forEach((mesh, i) => {
    mesh.skeleton.update();
    const {index} = mesh.geometry;
    assert.equal(index.count, ours.groups[i].length);
    for (let k = 0; k < index.count; k += 5) {
      mesh.getVertexPosition(index.getX(k), place);
      mesh.localToWorld(place).divideScalar(metresPerUnit);
      const there = new THREE.Vector3().fromArray(ours.vertices[ours.groups[i][k]]);
      worst = Math.max(worst, place.distanceTo(there) / size);
    }
  });
  return worst;
}

/// Of all that is seen, at rest, in metres.
export function heightOf({gltf}) {
  return new THREE.Box3().setFromObject(gltf.scene).getSize(new THREE.Vector3()).y;
}
