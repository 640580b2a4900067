// SPDX-License-Identifier: BSD-3-Clause
import {DirectionalLight, HemisphereLight, OrthographicCamera, PerspectiveCamera, Scene, Sphere, Vector2, Vector3, WebGLRenderer} from 'three';
import {OrbitControls} from 'three/addons/controls/OrbitControls.js';
import type {Colours} from './colours.ts';
import type {MachineScene} from './machine_scene.ts';
import {disposeAll} from './body_object.ts';
import {axesMark} from './marks.ts';
import {partAt, type Picked} from './picking.ts';
import {sharePrograms} from './shader_programs.ts';

export type View = 'oblique' | 'front' | 'side' | 'top';
const DIRECTIONS: Record<View, [number, number, number]> = {oblique: [0.75, -1, 0.55], front: [0, -1, 0], side: [1, 0, 0], top: [0, 0, 1]};

const QUICK = 8;  // ms that every picture may take; without a graphics processor one takes 20 … 30
/// Share of the time that slower ones may take, while numbers move and while the machine moves alone.
export const BESIDE_NUMBERS = 0.05, ALONE = 0.5;
const POLL = 4;  // ms between two looks at whether a picture is finished

/// Camera, light and renderer. It draws only when something changed.
export class Stage {
  readonly renderer: WebGLRenderer;
  readonly camera = new PerspectiveCamera(28, 1, 0.01, 100);
  private readonly scene = new Scene();
  private readonly controls: OrbitControls;
  private readonly light = new DirectionalLight(0xffffff, 2);
  private machine: MachineScene | null = null;
  private readonly corner = new Scene();  // the axes of the project, in a corner of the canvas
  private readonly cornerCamera = new OrthographicCamera(-1.6, 1.6, 1.6, -1.6, 0.1, 10);
  private wanted = false;
  private later: ReturnType<typeof setTimeout> | undefined;
  isBehind = false;  // what is drawn, of the present numbers
  private isMeasuring = false;  // how long the last picture takes
  private isDisposed = false;
  private share = ALONE;
  private taken = {until: 0, time: 0};  // when the last one was finished, and how long it took [ms]

  constructor(canvas: HTMLCanvasElement, background: number, private readonly beforeFrame: () => void) {
    this.renderer = new WebGLRenderer({canvas, antialias: true});
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setClearColor(background);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener('change', () => this.draw());
    this.scene.add(new HemisphereLight(0xffffff, 0x8899aa, 1.6), this.light);
  }
  show(machine: MachineScene, colours: Colours, fit: boolean) {
    if (this.machine) this.scene.remove(this.machine.root);
    this.machine?.dispose();
    this.machine = machine;
    this.scene.add(machine.root);
    this.renderer.setClearColor(colours.background);
    disposeAll(this.corner);
    this.corner.clear();
    this.corner.add(axesMark(1, colours), new HemisphereLight(), new DirectionalLight());  // shader programs depend on how many lights there are
    sharePrograms(this.corner);
    if (fit) this.look('oblique');
    this.draw();
  }
  look(view: View) {
    if (!this.machine) return;
    const sphere = this.machine.bounds.getBoundingSphere(new Sphere()), distance = sphere.radius * this.reach(), direction = new Vector3(...DIRECTIONS[view]).normalize();
    if (view === 'top') direction.add(new Vector3(0, -1e-3, 0));
    this.controls.target.copy(sphere.center);
    this.camera.position.copy(sphere.center).addScaledVector(direction, distance);
    [this.camera.near, this.camera.far] = [distance / 50, distance * 20];
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.draw();
  }
  /// Turns the camera about the machine [rad], or goes closer: for the keyboard.
  turn(right: number, upwards: number, closer = 1) {
    const {target} = this.controls, arm = this.camera.position.clone().sub(target).multiplyScalar(closer);
    const side = new Vector3().crossVectors(this.camera.up, arm).normalize();
    arm.applyAxisAngle(this.camera.up, right);
    const angle = arm.angleTo(this.camera.up);
    if (angle - upwards > 0.05 && angle - upwards < Math.PI - 0.05) arm.applyAxisAngle(side.applyAxisAngle(this.camera.up, right), -upwards);
    this.camera.position.copy(target).add(arm);
    this.controls.update();
    this.draw();
  }
  /// Distance from which a sphere of radius 1 fills the canvas.
  private reach(): number {
    const half = this.camera.fov * Math.PI / 360, narrow = Math.min(half, Math.atan(Math.tan(half) * this.camera.aspect));
    return 1.02 / Math.sin(narrow);
  }
  resize(width: number, height: number) {
    if (width < 1 || height < 1) return;
    this.renderer.setSize(width, height, false);
    const before = this.reach();
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    const arm = this.camera.position.clone().sub(this.controls.target).multiplyScalar(this.reach() / before);
    this.camera.position.copy(this.controls.target).add(arm);  // what was seen stays in sight
    this.draw();
  }
  draw() {
    this.isBehind = false;
    if (this.wanted) return;
    this.wanted = true;
    requestAnimationFrame(() => {
      this.wanted = false;
      if (!this.isDisposed) this.drawNow();
    });
  }
  /// Draws as soon as slow pictures have taken no more than this share of the time: curves and hands do not wait for them.
  drawWhenFree(share: number) {
    this.isBehind = true;
    this.share = share;
    if (this.isMeasuring || this.later !== undefined) return;
    this.later = setTimeout(() => {
      this.later = undefined;
      this.draw();
      this.isMeasuring = true;
      requestAnimationFrame(() => this.isDisposed || this.measure(performance.now()));
    }, Math.max(0, this.taken.until + this.taken.time * (1 / share - 1) - performance.now()));
  }
  /// Waits for the picture that was begun at this time: only the graphics processor knows how long it takes.
  private measure(begun: number) {
    const gl = this.renderer.getContext() as WebGL2RenderingContext, fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    const look = () => {
      if (this.isDisposed) return;
      if (fence && !gl.isContextLost() && gl.clientWaitSync(fence, 0, 0) === gl.TIMEOUT_EXPIRED) return void setTimeout(look, POLL);
      gl.deleteSync(fence);
      const until = performance.now(), time = until - begun;
      this.taken = {until, time: time < QUICK ? 0 : time};
      this.isMeasuring = false;
      if (this.isBehind) this.drawWhenFree(this.share);
    };
    look();
  }
  drawNow() {
    this.beforeFrame();
    this.light.position.copy(this.camera.position).add(new Vector3(0, 0, this.camera.position.length()));
    this.renderer.render(this.scene, this.camera);
    this.drawCorner();
  }
  private drawCorner() {
    const side = 84, {x: width} = this.renderer.getSize(new Vector2());
    this.cornerCamera.up.copy(this.camera.up);
    this.cornerCamera.position.copy(this.camera.position).sub(this.controls.target).setLength(5);
    this.cornerCamera.lookAt(0, 0, 0);
    this.renderer.autoClear = false;
    this.renderer.setViewport(width - side, 0, side, side);
    this.renderer.clearDepth();
    this.renderer.render(this.corner, this.cornerCamera);
    this.renderer.setViewport(0, 0, width, this.renderer.getSize(new Vector2()).y);
    this.renderer.autoClear = true;
  }
  /// What is at a place of the canvas, from −1 to 1.
  pick(x: number, y: number): Picked | null {
    return this.machine && partAt(this.machine.root, this.camera, new Vector2(x, y), this.renderer.getSize(new Vector2()));
  }
  dispose() {
    this.isDisposed = true;
    clearTimeout(this.later);
    this.machine?.dispose();
    this.controls.dispose();
    this.renderer.dispose();
  }
}
