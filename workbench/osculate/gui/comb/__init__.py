"""The task panel of a CurvatureComb."""
