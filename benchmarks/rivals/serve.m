% SPDX-License-Identifier: BSD-3-Clause
% Answers requests for ways (a struct of functions) line by line: their names, answers written to a file, CPU seconds of one call.
function serve(folder, ways)
  while ischar(request = fgetl(stdin))
    [what, name] = strtok(request);
    name = strtrim(name);
    switch what
      case "names"
        printf("%s\n", strjoin(fieldnames(ways), " "));
      case "answer"
        x = ways.(name)();
        file = fopen(fullfile(folder, [name ".answer"]), "w");
        fwrite(file, [real(x(:)).'; imag(x(:)).'], "double");
        fclose(file);
        printf("done\n");
      case "time"
        calls = 0;
        from = cputime();
        do
          ways.(name)();
          calls++;
          spent = cputime() - from;
        until spent >= 1e-3
        printf("%.12g\n", spent / calls);
    endswitch
    fflush(stdout);
  endwhile
endfunction
