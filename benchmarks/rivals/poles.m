% SPDX-License-Identifier: BSD-3-Clause
% Poles and residues of (K + s B + s^2 A)^-1 H.
function [R, lambda] = poles(A, B, K, H)
  [V, D] = eig([zeros(6), eye(6); -A \ K, -A \ B]);
  lambda = diag(D);
  R = V(1:6, :) .* (V \ [zeros(6, 1); A \ H]).';
endfunction
