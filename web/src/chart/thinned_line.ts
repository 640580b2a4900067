// SPDX-License-Identifier: BSD-3-Clause

/// What draws it: a Path2D.
export interface Pen {
  moveTo(x: number, y: number): void;
  lineTo(x: number, y: number): void;
}
/// px, along y, by which a drawn line may miss a point: less than is seen.
export const NEAR = 0.15;

/// A line through points whose x grows. It leaves out points that a straight line passes closely: most of a curve is smooth, and without a
/// graphics processor its picture takes as long as it has corners.
export class ThinnedLine {
  private from: [number, number] | null = null;  // the last corner
  private last: [number, number] = [0, 0];
  private slopes: [number, number] = [0, 0];  // of lines from the corner that pass all later points

  constructor(private readonly pen: Pen) {}

  add(x: number, y: number) {
    if (!this.from) {
      this.pen.moveTo(x, y);
      this.begin(x, y);
      return;
    }
    if (this.last !== this.from && !this.isPassed(x, y)) {
      this.pen.lineTo(...this.last);
      this.begin(...this.last);
    }
    const dx = x - this.from[0];
    this.slopes = [Math.max(this.slopes[0], (y - NEAR - this.from[1]) / dx), Math.min(this.slopes[1], (y + NEAR - this.from[1]) / dx)];
    this.last = [x, y];
  }
  /// Ends the line; the next point begins another one.
  end() {
    if (this.from && this.last !== this.from) this.pen.lineTo(...this.last);
    this.from = null;
  }
  private begin(x: number, y: number) {
    this.from = this.last = [x, y];
    this.slopes = [-Infinity, Infinity];
  }
  private isPassed(x: number, y: number) {
    const slope = (y - this.from![1]) / (x - this.from![0]);
    return slope >= this.slopes[0] && slope <= this.slopes[1];
  }
}
