// SPDX-License-Identifier: BSD-3-Clause
// Style sheets are bundled as texts.
declare module '*.css' {
  const text: string;
  export default text;
}
