within Segfmu;
package FMI "An FMU as functions of time, states and inputs"
  class Instance "An instance of an FMU of FMI 2.0 model exchange"
    extends ExternalObject;

    function constructor "Load the FMU's binary and make an instance"
      input String folder "folder of the unpacked FMU; empty: Resources/FMUs/name of this package";
      input String name "name of the FMU";
      input String instanceName "name in messages";
      input String token "identifier of the FMU's description, its guid";
      input Integer states "number of continuous states";
      output Instance fmu;
    external "C" fmu = segfmu_open(folder, name, instanceName, token, states)
        annotation(Include = "#include \"segfmu_fmu.h\"", IncludeDirectory = "modelica://Segfmu/Resources/Include");
    end constructor;

    function destructor "Free the instance"
      input Instance fmu;
    external "C" segfmu_close(fmu)
        annotation(Include = "#include \"segfmu_fmu.h\"", IncludeDirectory = "modelica://Segfmu/Resources/Include");
    end destructor;
  end Instance;

  function start "Begin the initialisation with parameters"
    input Instance fmu;
    input Real startTime(unit = "s");
    input Integer realReferences[:] "value references of parameters";
    input Real reals[size(realReferences, 1)];
    input Integer integerReferences[:];
    input Integer integers[size(integerReferences, 1)];
    input Integer booleanReferences[:];
    input Integer booleans[size(booleanReferences, 1)] "1: true";
    output Real started "the start time";
  external "C" started = segfmu_start(fmu, startTime,
      realReferences, reals, size(reals, 1), integerReferences, integers, size(integers, 1),
      booleanReferences, booleans, size(booleans, 1))
      annotation(Include = "#include \"segfmu_fmu.h\"", IncludeDirectory = "modelica://Segfmu/Resources/Include");
  end start;

  function states "States at the start"
    input Instance fmu;
    input Integer inputReferences[:] "of the inputs that they can follow from";
    input Real inputs[size(inputReferences, 1)];
    input Integer count;
    input Real started "result of start";
    output Real x[count];
  external "C" segfmu_states(fmu, inputReferences, inputs, size(inputs, 1), x, count)
      annotation(Include = "#include \"segfmu_fmu.h\"", IncludeDirectory = "modelica://Segfmu/Resources/Include");
  end states;

  function begin "End the initialisation, under all inputs"
    input Instance fmu;
    input Integer inputReferences[:];
    input Real inputs[size(inputReferences, 1)];
    input Real started "result of start";
    output Real begun "the start time";
  external "C" begun = segfmu_begin(fmu, inputReferences, inputs, size(inputs, 1))
      annotation(Include = "#include \"segfmu_fmu.h\"", IncludeDirectory = "modelica://Segfmu/Resources/Include");
  end begin;

  function event "The event at a time, in the FMU"
    input Instance fmu;
    input Real t(unit = "s");
    input Real x[:];
    input Integer inputReferences[:];
    input Real inputs[size(inputReferences, 1)];
    input Real begun "result of begin";
    output Real next(unit = "s") "time of the next event";
  external "C" next = segfmu_event(fmu, t, x, size(x, 1), inputReferences, inputs, size(inputs, 1))
      annotation(Include = "#include \"segfmu_fmu.h\"", IncludeDirectory = "modelica://Segfmu/Resources/Include");
  end event;

  function derivatives "Derivatives of the states"
    input Instance fmu;
    input Real t(unit = "s");
    input Real x[:];
    input Integer inputReferences[:] "of the inputs that they follow from";
    input Real inputs[size(inputReferences, 1)];
    input Real last "changes with every event";
    output Real rates[size(x, 1)];
  external "C" segfmu_derivatives(fmu, t, x, size(x, 1), inputReferences, inputs, size(inputs, 1), rates)
      annotation(Include = "#include \"segfmu_fmu.h\"", IncludeDirectory = "modelica://Segfmu/Resources/Include");
  end derivatives;

  function reals "Real outputs"
    input Instance fmu;
    input Real t(unit = "s");
    input Real x[:];
    input Integer inputReferences[:] "of the inputs that they follow from";
    input Real inputs[size(inputReferences, 1)];
    input Integer references[:];
    input Real last "changes with every event";
    output Real values[size(references, 1)];
  external "C" segfmu_reals(fmu, t, x, size(x, 1), inputReferences, inputs, size(inputs, 1),
      references, values, size(references, 1))
      annotation(Include = "#include \"segfmu_fmu.h\"", IncludeDirectory = "modelica://Segfmu/Resources/Include");
  end reals;

  function integer "An Integer output, which changes at events alone"
    input Instance fmu;
    input Integer reference;
    input Real last "changes with every event";
    output Integer value;
  external "C" value = segfmu_integer(fmu, reference)
      annotation(Include = "#include \"segfmu_fmu.h\"", IncludeDirectory = "modelica://Segfmu/Resources/Include");
  end integer;

  function boolean "A Boolean output, which changes at events alone"
    input Instance fmu;
    input Integer reference;
    input Real last "changes with every event";
    output Boolean value;
  external "C" value = segfmu_boolean(fmu, reference)
      annotation(Include = "#include \"segfmu_fmu.h\"", IncludeDirectory = "modelica://Segfmu/Resources/Include");
  end boolean;

  function rows "The rows of a table, one behind the other"
    input Real table[:, :];
    output Real values[size(table, 1)*size(table, 2)];
  algorithm
    for i in 1:size(table, 1) loop
      for j in 1:size(table, 2) loop
        values[(i - 1)*size(table, 2) + j] := table[i, j];
      end for;
    end for;
  end rows;

  function truths "The rows of a table, one behind the other, 1 where it is true"
    input Boolean table[:, :];
    output Integer values[size(table, 1)*size(table, 2)];
  algorithm
    for i in 1:size(table, 1) loop
      for j in 1:size(table, 2) loop
        values[(i - 1)*size(table, 2) + j] := if table[i, j] then 1 else 0;
      end for;
    end for;
  end truths;

  function references "Value references of the first rows of a table"
    input Integer table[:, :];
    input Integer count "of the rows";
    output Integer values[count*size(table, 2)];
  algorithm
    for i in 1:count loop
      for j in 1:size(table, 2) loop
        values[(i - 1)*size(table, 2) + j] := table[i, j];
      end for;
    end for;
  end references;
end FMI;
