// A dog of five strokes, drawn by hand, and the shapes it is made of.
import {circle, closed, dense} from './harness.mjs';

export const ellipse = (x, y, a, b, n = 60) => dense(closed(Array.from({length: n}, (_, i) => {
  const angle = 2 * Math.PI * i / n;
  return [x + a * Math.cos(angle), y + b * Math.sin(angle)];
})), 8);
export const ring = (x, y, radius) => dense(closed(circle(x, y, radius)), 6);

/// A limb of a width along some points, from the first to the last and back.
export function limb(points, width) {
  const side = (sign) => points.map(([x, y], i) => {
    const [ax, ay] = points[Math.max(i - 1, 0)];
    const [bx, by] = points[Math.min(i + 1, points.length - 1)];
    const length = Math.hypot(bx - ax, by - ay);
    return [x - sign * (by - ay) / length * width, y + sign * (bx - ax) / length * width];
  });
  return dense(closed([...side(1), ...side(-1).reverse()]), 6);
}

// A dog seen from its side, about 500 pixels long.
export const dog = {
  body: ellipse(620, 380, 170, 72),
  frontLeg: limb([[530, 395], [528, 470], [520, 560]], 20),
  hindLeg: limb([[715, 395], [722, 470], [716, 560]], 20),
  head: ring(440, 300, 66),
  tail: limb([[778, 360], [830, 320], [870, 260]], 14),
};

export async function drawDog(app) {
  for (const name of ['body', 'frontLeg', 'hindLeg', 'head', 'tail']) await app.draw(dog[name]);
}
