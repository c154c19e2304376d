// Programs of WebGL, and solids: triangles lit by the light above the viewer.

export const NO_WEBGL = "This browser has no WebGL: nothing can be drawn, the numbers are computed all the same.";

export function program(gl, vertex, fragment) {
  const made = gl.createProgram();
  for (const [type, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, `#version 300 es\n${source}`);
    gl.compileShader(shader);
    gl.attachShader(made, shader);
  }
  gl.linkProgram(made);
  if (!gl.getProgramParameter(made, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(made));
  return made;
}

const VERTEX = `layout(location=0) in vec3 corner; uniform mat4 view; uniform mat3 turn; out vec3 p;
void main() { p = turn * corner; gl_Position = view * vec4(corner, 1.); }`;
const FRAGMENT = `precision highp float; in vec3 p; uniform vec3 tint; out vec4 colour;
void main() {
  vec3 n = normalize(cross(dFdx(p), dFdy(p)));
  colour = vec4(tint * (.5 + .5 * abs(dot(n, normalize(vec3(.3, .5, .8))))), 1.);
}`;

export class Solids {
  #gl;
  #program;
  #place = {};
  #corners;
  #order;
  #indices;
  constructor(gl) {
    this.#gl = gl;
    this.#program = program(gl, VERTEX, FRAGMENT);
    for (const name of ["view", "turn", "tint"]) this.#place[name] = gl.getUniformLocation(this.#program, name);
    [this.#corners, this.#order] = [gl.createBuffer(), gl.createBuffer()];
    gl.bindBuffer(gl.ARRAY_BUFFER, this.#corners);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.#order);
    gl.enable(gl.DEPTH_TEST);
    gl.useProgram(this.#program);
  }
  clear() {
    const gl = this.#gl;
    gl.viewport(0, 0, gl.canvas.width, gl.canvas.height);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
  }
  /** Triangles of corners; `view` leads to the screen, `turn` to the viewer's right, up and near. */
  draw(corners, indices, tint, { view, turn }) {
    const gl = this.#gl;
    gl.bufferData(gl.ARRAY_BUFFER, corners, gl.DYNAMIC_DRAW);
    if (this.#indices !== indices) gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, (this.#indices = indices), gl.STATIC_DRAW);
    gl.uniformMatrix4fv(this.#place.view, false, view);
    gl.uniformMatrix3fv(this.#place.turn, false, turn);
    gl.uniform3fv(this.#place.tint, tint.map((x) => x / 255));
    gl.drawElements(gl.TRIANGLES, indices.length, gl.UNSIGNED_INT, 0);
  }
}

const SIDES = 10;
const minus = (a, b) => a.map((x, k) => x - b[k]);
const cross = ([a, b, c], [x, y, z]) => [b * z - c * y, c * x - a * z, a * y - b * x];
const unit = (a) => a.map((x) => x / (Math.hypot(...a) || 1));

/** Rods from place to place, each [from, to, radius there, radius here], as corners and indices. */
export class Rods {
  constructor(count) {
    this.corners = new Float32Array(3 * count * 2 * (SIDES + 1));
    const indices = [];
    for (let rod = 0; rod < count; rod++) {
      const first = rod * 2 * (SIDES + 1);
      for (let k = 0; k < SIDES; k++) {
        const [a, b] = [first + k, first + ((k + 1) % SIDES)],
          [c, d] = [a + SIDES, b + SIDES];
        indices.push(a, b, c, b, d, c, a, b, first + 2 * SIDES, c, d, first + 2 * SIDES + 1);
      }
    }
    this.indices = Uint32Array.from(indices);
  }
  set(rods) {
    rods.forEach(([from, to, thick, thin], rod) => {
      const along = unit(minus(to, from)),
        side = unit(cross(along, Math.abs(along[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0])),
        other = cross(along, side);
      let at = 6 * rod * (SIDES + 1);
      const add = (p) => {
        this.corners.set(p, at);
        at += 3;
      };
      for (const [end, radius] of [[from, thick], [to, thin]])
        for (let k = 0; k < SIDES; k++) {
          const [c, s] = [Math.cos((2 * Math.PI * k) / SIDES), Math.sin((2 * Math.PI * k) / SIDES)];
          add(end.map((x, i) => x + radius * (c * side[i] + s * other[i])));
        }
      add(minus(from, along.map((x) => 0.5 * thick * x)));
      add(minus(to, along.map((x) => -0.5 * thin * x)));
    });
  }
}
