"""Views and statements of what is done with readings of the ADC and of sensors."""
