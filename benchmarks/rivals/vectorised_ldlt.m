% SPDX-License-Identifier: BSD-3-Clause
% The same by LDL' without pivoting, each entry a vector over frequencies.
function q = vectorised_ldlt(A, B, K, H, p)
  x = p.^2;
  L = cell(6, 6);
  y = cell(1, 6);
  for j = 1:6
    for i = j:6
      z = (K(i, j) - A(i, j) * x) + 1i * (B(i, j) * p);
      for k = 1:j-1
        z -= L{i, k} .* D{j, k};
      endfor
      if i == j
        d = 1 ./ z;
        y{j} = H(j);
        for k = 1:j-1
          y{j} = y{j} - L{j, k} .* y{k};
        endfor
        inverse{j} = d;
      else
        D{i, j} = z;
        L{i, j} = z .* d;
      endif
    endfor
  endfor
  q = zeros(6, numel(p));
  for i = 6:-1:1
    s = y{i} .* inverse{i};
    for k = i+1:6
      s -= L{k, i} .* q(k, :);
    endfor
    q(i, :) = s;
  endfor
endfunction
